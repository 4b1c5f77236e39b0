#include "anamorphosis/match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <optional>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

// A hit on the sculpture by way of the mirror; without a mirror, seen directly.
struct ReflectedHit {
  std::uint32_t sourceTriangle;
  Point original;
};

struct PixelResult {
  PixelClass kind = PixelClass::background;
  float errorPx = 0;
  bool sameTriangle = false;
};

// The same triangle, or one that shares an edge with it. Corners at the same place are the same, so that it
// works across texture seams, where files repeat positions.
bool touch(const PointArray& points, const Triangle& a, const Triangle& b) {
  const auto shared = std::count_if(a.begin(), a.end(), [&](std::uint32_t corner) {
    return std::any_of(b.begin(), b.end(), [&](std::uint32_t other) {
      return corner == other || points[corner] == points[other];
    });
  });
  return shared >= 2;
}

class Matcher {
 public:
  explicit Matcher(const MatchInput& input)
      : input_(input), projection_(input.camera, input.width, input.height) {}

  PixelResult pixel(int x, int y) const {
    const Pixel sample = matchSample(x, y);
    const Ray ray = projection_.rayThrough(sample);
    BvhHit first;
    const bool seesOriginal = input_.originalBvh->closestHit(ray, first);

    const LineOfSight sight = lineOfSight(input_.optic, ray);
    const bool hidden = sculptureStandsInTheWay(sight);
    std::optional<ReflectedHit> reflected;
    if (!sight.ends && !hidden) reflected = sculptureAlong(sight.last, sight.length);

    PixelResult result;
    if (seesOriginal && reflected) {
      result.kind = PixelClass::both;
      const auto seenAt = projection_.pixelOf(reflected->original);
      const double error = seenAt ? glm::length(*seenAt - sample) : worstError();
      result.errorPx = static_cast<float>(std::min(error, worstError()));
      const auto& triangles = input_.original->triangles;
      result.sameTriangle =
          touch(input_.original->positions, triangles[first.triangle], triangles[reflected->sourceTriangle]);
    } else if (seesOriginal) {
      result.kind = !sight.meets ? PixelClass::missed
                    : hidden     ? PixelClass::hidden
                                 : PixelClass::onlyOriginal;
    } else if (reflected) {
      result.kind = PixelClass::onlyReflection;
    }
    return result;
  }

 private:
  double worstError() const { return std::max(projection_.width(), projection_.height()); }

  // Between the eye and the last point on the optic.
  bool sculptureStandsInTheWay(const LineOfSight& sight) const {
    Point from = projection_.eye();
    for (int i = 0; i < sight.bendCount; ++i) {
      const Point& to = sight.bends[static_cast<std::size_t>(i)];
      if (input_.sculptureBvh->anyHit({from, to - from}, 0, 1)) return true;
      from = to;
    }
    return false;
  }

  std::optional<ReflectedHit> sculptureAlong(const Ray& ray, double length) const {
    BvhHit hit;
    if (!input_.sculptureBvh->closestHit(ray, hit, 0, length)) return std::nullopt;
    const Sculpture& s = *input_.sculpture;
    const Triangle& t = s.mesh.triangles[hit.triangle];
    const Point original =
        (1 - hit.u - hit.v) * s.original[t[0]] + hit.u * s.original[t[1]] + hit.v * s.original[t[2]];
    return ReflectedHit{s.sourceTriangle[hit.triangle], original};
  }

  const MatchInput& input_;
  Projection projection_;
};

MatchReport summarize(const std::vector<PixelResult>& pixels, const MatchInput& input) {
  MatchReport report;
  report.width = input.width;
  report.height = input.height;
  std::array<std::size_t, 6> count{};
  std::vector<float> errors;
  std::size_t sameTriangle = 0;
  double sum = 0;
  for (const PixelResult& pixel : pixels) {
    ++count[static_cast<std::size_t>(pixel.kind)];
    if (pixel.kind != PixelClass::both) continue;
    errors.push_back(pixel.errorPx);
    sum += static_cast<double>(pixel.errorPx);
    sameTriangle += pixel.sameTriangle;
  }
  const auto of = [&](PixelClass kind) { return static_cast<double>(count[static_cast<std::size_t>(kind)]); };
  const double both = of(PixelClass::both);
  const double original =
      both + of(PixelClass::onlyOriginal) + of(PixelClass::hidden) + of(PixelClass::missed);
  const double either = original + of(PixelClass::onlyReflection);
  if (either > 0) report.silhouetteIou = both / either;
  if (original > 0) {
    report.hiddenShare = of(PixelClass::hidden) / original;
    report.missedShare = of(PixelClass::missed) / original;
  }
  report.comparedPixels = errors.size();
  if (errors.empty()) return report;
  report.meanPx = sum / both;
  report.triangleAgreement = static_cast<double>(sameTriangle) / both;
  std::sort(errors.begin(), errors.end());
  report.p99Px = static_cast<double>(errors[(errors.size() - 1) * 99 / 100]);
  report.maxPx = static_cast<double>(errors.back());
  return report;
}

}  // namespace

Pixel matchSample(int x, int y) {
  // The finalizer of MurmurHash3 mixes all bits of both coordinates.
  std::uint64_t hash = std::uint64_t{static_cast<std::uint32_t>(y)} << 32 | static_cast<std::uint32_t>(x);
  hash = (hash ^ hash >> 33) * 0xFF51AFD7ED558CCDu;
  hash = (hash ^ hash >> 33) * 0xC4CEB9FE1A85EC53u;
  hash ^= hash >> 33;
  constexpr double unit = 1.0 / 4294967296;
  return {x + (static_cast<double>(hash >> 32) + 0.5) * unit,
          y + (static_cast<double>(hash & 0xFFFFFFFF) + 0.5) * unit};
}

Match computeMatch(const MatchInput& input, int threads, const Progress& progress) {
  const auto width = static_cast<std::size_t>(input.width), height = static_cast<std::size_t>(input.height);
  const Matcher matcher(input);
  std::vector<PixelResult> pixels(width * height);
  std::mutex reporting;
  std::size_t rowsDone = 0;
  parallelFor(height, 8, threads, [&](std::size_t firstRow, std::size_t lastRow) {
    if (progress.cancelled()) return;
    for (std::size_t y = firstRow; y < lastRow; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        pixels[y * width + x] = matcher.pixel(static_cast<int>(x), static_cast<int>(y));
      }
    }
    const std::lock_guard<std::mutex> lock(reporting);
    rowsDone += lastRow - firstRow;
    progress.update(static_cast<double>(rowsDone) / static_cast<double>(height));
  });
  if (progress.cancelled()) return {};
  Match match;
  match.report = summarize(pixels, input);
  match.classes.reserve(pixels.size());
  for (const PixelResult& pixel : pixels) match.classes.push_back(pixel.kind);
  return match;
}

MatchGrade gradeOf(const MatchReport& report) {
  const bool clean = report.hiddenShare == 0 && report.missedShare == 0;
  const bool exact = report.p99Px <= 0.5 && report.triangleAgreement >= 0.995;
  if (report.silhouetteIou >= 0.995 && clean && exact) return MatchGrade::excellent;
  if (report.silhouetteIou >= 0.99 && report.p99Px <= 1 && report.triangleAgreement >= 0.99)
    return MatchGrade::match;
  if (report.silhouetteIou >= 0.5) return MatchGrade::partial;
  return MatchGrade::none;
}

const char* matchGradeName(MatchGrade grade) {
  constexpr const char* names[] = {"excellent", "match", "partial", "none"};
  return names[static_cast<int>(grade)];
}

}  // namespace anamorph
