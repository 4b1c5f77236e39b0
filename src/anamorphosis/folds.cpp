#include "anamorphosis/folds.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "anamorphosis/ray_bundle.h"
#include "base/parallel_for.h"

namespace anamorph {
namespace {

constexpr std::size_t enough = 64;  // triangles that tell which way round a sculpture is

class FoldFinder {
 public:
  FoldFinder(const VertexMap& map, const PointArray& original, const std::vector<Triangle>& triangles,
             const std::vector<PathStatus>& status, const CancelToken& token)
      : map_(map), original_(original), triangles_(triangles), status_(status), token_(token) {}

  bool mapped(const Triangle& t) const {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return status_[v] == PathStatus::mapped; });
  }

  // By some of the triangles, evenly over the list first; where little is mapped, one after the other.
  bool isReversed() const {
    double balance = 0;
    std::size_t asked = 0;
    for (const std::size_t stride : {std::max<std::size_t>(1, triangles_.size() / enough), std::size_t{1}}) {
      for (std::size_t i = 0; i < triangles_.size() && asked < enough; i += stride) {
        if (!mapped(triangles_[i])) continue;
        balance += orientation(bundleOf(triangles_[i]));
        ++asked;
      }
      if (asked > 0) break;
    }
    return balance < 0;
  }

  Folds find(int threads) {
    followAll(threads);
    std::vector<double> orientations(triangles_.size(), 0);
    parallelFor(orientations.size(), 1024, threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        if (mapped(triangles_[i])) orientations[i] = orientation(bundleOf(triangles_[i]));
      }
    });
    Folds folds;
    if (token_.cancelled()) return folds;
    double same = 0, reversed = 0;
    for (const double seen : orientations) (seen < 0 ? reversed : same) += std::abs(seen);
    folds.reversed = reversed > same;
    if (!(std::min(same, reversed) > 0)) return folds;
    folds.folded.assign(triangles_.size(), 0);
    for (std::size_t i = 0; i < orientations.size(); ++i) {
      if (orientations[i] == 0 || (orientations[i] < 0) == folds.reversed) continue;
      const auto bundle = bundleOf(triangles_[i]);
      if (bundle->edgeOn()) continue;
      folds.folded[i] = 1;
      ++folds.count;
      folds.share += std::abs(orientations[i]) / (same + reversed);
      note(*bundle, folds.foci);
    }
    return folds;
  }

 private:
  void followAll(int threads) {
    rays_.resize(original_.size());
    parallelFor(rays_.size(), 256, threads, [&](std::size_t first, std::size_t last) {
      if (token_.cancelled()) return;
      for (std::size_t i = first; i < last; ++i) {
        if (status_[i] == PathStatus::mapped) rays_[i] = exitRayTowards(map_, original_[i]);
      }
    });
  }

  std::optional<RayBundle> bundleOf(const Triangle& triangle) const {
    std::array<ExitRay, 3> rays;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto ray = rays_.empty() ? exitRayTowards(map_, original_[triangle[i]]) : rays_[triangle[i]];
      if (!ray) return std::nullopt;
      rays[i] = *ray;
    }
    return RayBundle(rays);
  }

  // As large as the triangle seems from the eye; negative where its bundle is turned around at the corners' mean distance.
  static double orientation(const std::optional<RayBundle>& bundle) {
    if (!bundle) return 0;
    const double spread = bundle->spread(bundle->distance()), size = std::abs(bundle->sizeAtEye());
    return spread > 0 ? size : spread < 0 ? -size : 0;
  }

  // Of both foci the one that the triangle is nearer to: the other is not what divides it from the rest.
  static void note(const RayBundle& bundle, FocusRange& range) {
    const std::vector<double> foci = bundle.foci();
    if (foci.empty()) return;
    const auto apart = [&](double focus) { return std::abs(focus - bundle.distance()); };
    const double focus =
        *std::min_element(foci.begin(), foci.end(), [&](double a, double b) { return apart(a) < apart(b); });
    range.nearest = range.none() ? focus : std::min(range.nearest, focus);
    range.farthest = std::max(range.farthest, focus);
  }

  const VertexMap& map_;
  const PointArray& original_;
  const std::vector<Triangle>& triangles_;
  const std::vector<PathStatus>& status_;
  const CancelToken& token_;
  std::vector<std::optional<ExitRay>>
      rays_;  // of every vertex; empty: they are followed when they are asked for
};

// With the published mistakes there is no telling where rays cross.
bool hasNoFolds(const VertexMap& map) {
  return map.mistakes.any() || (map.optic.parts.size() == 1 && seesConvexSide(map.optic.shape(), map.eye));
}

}  // namespace

Folds findFolds(const VertexMap& map, const PointArray& original, const std::vector<Triangle>& triangles,
                const std::vector<PathStatus>& status, int threads, const CancelToken& token) {
  FoldFinder finder(map, original, triangles, status, token);
  if (!hasNoFolds(map)) return finder.find(threads);
  Folds none;
  none.reversed = finder.isReversed();
  return none;
}

}  // namespace anamorph
