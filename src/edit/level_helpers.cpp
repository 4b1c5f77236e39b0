#include "edit/level_helpers.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "anamorphosis/map_points.h"
#include "edit/level_edits.h"
#include "pipeline/evaluator.h"

namespace anamorph {
namespace {

constexpr double margin = 0.98;
constexpr double highest = 85;          // degrees: straight from above there is no up any more
constexpr double fineDegrees = 0.1;     // how well the height is found
constexpr int coarse = 96, fine = 256;  // pixels

// Whether every vertex is mapped when the original is scaled about `centre`.
class Fits {
 public:
  Fits(const LevelScene& level, const PointArray& placed, const Point& centre)
      : map_(makeVertexMap(level)), placed_(placed), centre_(centre) {
    map_.mistakes = {};
  }

  bool operator()(double factor) {
    scaled_ = mapPoints(placed_, [&](const Point& p) { return centre_ + factor * (p - centre_); });
    mapPointsThrough(map_, scaled_, mapped_);
    return std::all_of(mapped_.status.begin(), mapped_.status.end(),
                       [](PathStatus status) { return status == PathStatus::mapped; });
  }

 private:
  VertexMap map_;
  const PointArray& placed_;
  Point centre_;
  PointArray scaled_;
  MappedPoints mapped_;
};

// The largest factor with which every vertex is mapped, less the margin; nothing where none is, or where it has no end.
std::optional<double> largestMapped(const Level& level, const PointArray& placed, const Point& centre) {
  Fits fits(level, placed, centre);
  constexpr double step = 1.5, smallest = 1e-4, largest = 1e4;
  double good = 1, bad = 1;
  if (fits(1)) {
    while (fits(bad *= step)) {
      good = bad;
      if (good > largest) return std::nullopt;  // a mirror without end
    }
  } else {
    do {
      good = bad / step;
      if (good < smallest) return std::nullopt;
      if (fits(good)) break;
      bad = good;
    } while (true);
  }
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (good + bad);
    (fits(middle) ? good : bad) = middle;
  }
  return fits(margin * good) ? std::optional(margin * good) : std::nullopt;
}

std::pair<Level, std::shared_ptr<const Mesh>> scaledOriginal(const Level& level, const Mesh& placed,
                                                             const Point& centre, double factor) {
  Mesh mesh = placed;
  mesh.positions =
      mapPoints(placed.positions, [&](const Point& p) { return centre + factor * (p - centre); });
  return {scaled(level, {Part::original}, centre, Vector(factor)),
          std::make_shared<const Mesh>(std::move(mesh))};
}

// The largest factor up to `largest` that is clear in both sizes of image: downwards in steps, then between the last
// two. Hiding does not grow with the size in any regular way, so no factor is skipped that a step would meet.
std::optional<double> largestClear(double largest, const std::function<bool(double, int)>& isClear,
                                   const CancelToken& token) {
  constexpr double step = 0.85;
  constexpr int steps = 24;
  double bad = largest;
  for (int i = 0; i < steps && !token.cancelled(); ++i, bad *= step) {
    double good = i == 0 ? largest : bad * step;
    if (!isClear(good, coarse)) continue;
    for (int k = 0; k < 4 && i > 0 && !token.cancelled(); ++k) {
      const double middle = 0.5 * (good + bad);
      (isClear(middle, coarse) ? good : bad) = middle;
    }
    for (const double factor : {good, margin * good}) {
      if (isClear(factor, fine)) return factor;
    }
    bad = good;
  }
  return std::nullopt;
}

// Around `pivot`, as high as `degrees` above the horizon; the side stays.
Point eyeAt(const Point& eye, const Point& pivot, double degrees) {
  const Vector arm = eye - pivot;
  const double flat = std::hypot(arm.x, arm.y), angle = radians(degrees);
  const Vector side = flat > 0 ? Vector(arm.x / flat, arm.y / flat, 0) : Vector(0, -1, 0);
  return pivot + glm::length(arm) * (std::cos(angle) * side + std::sin(angle) * Vector(0, 0, 1));
}

double heightOf(const Point& eye, const Point& pivot) {
  const Vector arm = eye - pivot;
  return std::atan2(arm.z, std::hypot(arm.x, arm.y)) * 180 / pi;
}

}  // namespace

CoarseView coarseView(const Level& level, std::shared_ptr<const Mesh> placed, int size, int threads,
                      const Progress& progress) {
  Level small = level;
  small.sculpture.imageSize = size;
  small.sculpture.maxTriangles = std::min<std::size_t>(small.sculpture.maxTriangles, 100'000);
  const auto finished = finishLevel(small, std::move(placed), threads, progress);
  if (!finished || finished->problem) return {};
  const Match match = matchLevel(*finished, size, size, threads, progress);
  if (progress.cancelled()) return {};
  const bool sound = match.report.comparedPixels > 0 && gradeOf(match.report) != MatchGrade::tooSmall;
  return {sound, match.report.hiddenShare, match.report.missedShare};
}

std::optional<Level> originalFittedToMirror(const Level& level, std::shared_ptr<const Mesh> placed,
                                            int threads, const Progress& progress) {
  if (!placed) return std::nullopt;
  const Box box = boundingBox(placed->positions);
  if (box.empty() || !(box.diagonal() > 0) || !isFinite(box.centre())) return std::nullopt;
  if (findProblem(level.optic) || findEyeProblem(level.optic, level.camera.eye)) return std::nullopt;
  const auto largest = largestMapped(level, placed->positions, box.centre());
  if (!largest) return std::nullopt;
  double done = 0;
  const auto isClear = [&](double factor, int size) {
    progress.update(done = std::min(0.98, done + 1.0 / 40));
    const auto [scaledLevel, mesh] = scaledOriginal(level, *placed, box.centre(), factor);
    return coarseView(scaledLevel, mesh, size, threads, {{}, progress.token}).clear();
  };
  const auto factor = largestClear(*largest, isClear, progress.token);
  if (progress.cancelled()) return std::nullopt;
  // What is as good as it can be is not made smaller.
  if ((!factor || *factor <= 1) && isClear(1, fine)) return level;
  if (!factor || progress.cancelled()) return std::nullopt;
  return scaledOriginal(level, *placed, box.centre(), *factor).first;
}

std::optional<Level> eyeLifted(const Level& level, std::shared_ptr<const Mesh> placed, int threads,
                               const Progress& progress) {
  if (!placed || placed->positions.empty()) return std::nullopt;
  const Point pivot = boundingBox(placed->positions).centre();
  const double start = heightOf(level.camera.eye, pivot);
  const auto lifted = [&](double degrees) {
    Level result = level;
    result.camera.eye = clampedPoint(eyeAt(level.camera.eye, pivot, degrees));
    return result;
  };
  double done = 0;
  const auto seen = [&](const Level& candidate, int size) {
    const CoarseView view = coarseView(candidate, placed, size, threads, {{}, progress.token});
    progress.update(done = std::min(0.98, done + 1.0 / 32));
    return view;
  };
  const CoarseView now = seen(level, fine);
  if (now.sound && now.hiddenShare == 0) return level;
  const double missed = now.sound ? std::max(now.missedShare, 0.005) : 0.005;
  const auto clear = [&](double degrees, int size) {
    const CoarseView view = seen(lifted(degrees), size);
    return view.sound && view.hiddenShare == 0 && view.missedShare <= missed;
  };
  if (start >= highest) return std::nullopt;
  constexpr int steps = 16;
  const double step = (highest - start) / steps;
  double bad = start;
  // Small images find where to look, a larger one decides; what only that one sees needs a little more.
  for (int i = 1; i <= steps && !progress.cancelled(); ++i) {
    double good = start + i * step;
    if (!clear(good, coarse)) {
      bad = good;
      continue;
    }
    while (good - bad > fineDegrees && !progress.cancelled()) {
      const double middle = 0.5 * (good + bad);
      (clear(middle, coarse) ? good : bad) = middle;
    }
    for (double more = 0; more < step && good + more <= highest && !progress.cancelled(); more += 0.5) {
      if (clear(good + more, fine))
        return progress.cancelled() ? std::nullopt : std::optional(lifted(good + more));
    }
    bad = start + i * step;
  }
  return std::nullopt;
}

}  // namespace anamorph
