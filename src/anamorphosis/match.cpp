#include "anamorphosis/match.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>

#include "anamorphosis/contour.h"
#include "anamorphosis/outline.h"
#include "base/check.h"
#include "base/parallel_for.h"

namespace anamorph {
namespace {

// Of an original that covers less than this no figure says anything: a share of the picture, within pixels.
constexpr double fewestShare = 0.0004, fewestPixels = 16, mostNeeded = 100;

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

// What one ray of the picture tells.
struct Sample {
  std::optional<std::uint32_t> original;  // the triangle that is seen
  bool meets = false;                     // the optic
  bool blocked = false;                   // something stands before what would be seen
  std::optional<ReflectedHit> reflected;

  bool shows() const { return reflected.has_value(); }
  PixelClass kind() const {
    if (!original) return shows() ? PixelClass::onlyReflection : PixelClass::background;
    if (shows()) return PixelClass::both;
    return !meets ? PixelClass::missed : blocked ? PixelClass::hidden : PixelClass::onlyOriginal;
  }
};

class Matcher {
 public:
  explicit Matcher(const MatchInput& input)
      : input_(input), projection_(input.camera, input.width, input.height) {
    if (input.originalMoved) placeSources(*input.sculpture, *input.original, moved_);
  }

  Sample at(const Pixel& place) const {
    const Ray ray = projection_.rayThrough(place);
    Sample sample;
    BvhHit first;
    if (input_.originalBvh->closestHit(ray, first)) sample.original = first.triangle;
    const LineOfSight sight = lineOfSight(input_.optic, ray);
    sample.meets = sight.meets;
    sample.blocked = isBlockedBeforeTheLastRay(sight);
    if (sight.ends || sample.blocked) return sample;

    const double limit = nearestObstacle(sight.last, sight.length);
    sample.reflected = sculptureAlong(sight.last, limit);
    sample.blocked = !sample.reflected && limit < sight.length &&
                     input_.sculptureBvh->anyHit(sight.last, limit, sight.length);
    return sample;
  }

  PixelResult pixel(int x, int y) const {
    const Pixel place = matchSample(x, y);
    const Sample sample = at(place);
    PixelResult result{sample.kind()};
    if (result.kind != PixelClass::both) return result;
    const auto seenAt = projection_.pixelOf(sample.reflected->original);
    const double error = seenAt ? glm::length(*seenAt - place) : worstError();
    result.errorPx = static_cast<float>(std::min(error, worstError()));
    const std::uint32_t shown = sample.reflected->sourceTriangle;
    result.sameTriangle =
        touches(*sample.original, shown) || (seenAt && isSeenAt(*seenAt, sample.reflected->original));
    return result;
  }

 private:
  bool touches(std::uint32_t a, std::uint32_t b) const {
    const auto& triangles = input_.original->triangles;
    return touch(input_.original->positions, triangles[a], triangles[b]);
  }

  // Whether the eye sees this point of the original there, and nothing that is more than a pixel's width before it. How
  // far that is from where the mirror shows it is the error's business: a fine mesh has many triangles within a tenth
  // of a pixel, and a sheet has two sides in one place.
  bool isSeenAt(const Pixel& place, const Point& point) const {
    const Ray ray = projection_.rayThrough(place), beside = projection_.rayThrough(place + Pixel(1, 0));
    BvhHit first;
    if (!input_.originalBvh->closestHit(ray, first)) return false;
    const double distance = glm::length(point - projection_.eye());
    const double width =
        distance * glm::length(glm::normalize(beside.direction) - glm::normalize(ray.direction));
    return glm::length(ray.at(first.t) - projection_.eye()) >= distance - width;
  }

  double worstError() const { return std::max(projection_.width(), projection_.height()); }

  // Between the eye and the last point on the optic.
  bool isBlockedBeforeTheLastRay(const LineOfSight& sight) const {
    Point from = projection_.eye();
    for (int i = 0; i < sight.bendCount; ++i) {
      const Point& to = sight.bends[static_cast<std::size_t>(i)];
      const Ray way{from, to - from};
      if (input_.sculptureBvh->anyHit(way, 0, 1) || nearestObstacle(way, 1) < 1) return true;
      from = to;
    }
    return false;
  }

  // How far the ray goes until it meets floor or obstacle; tMax when it does not.
  double nearestObstacle(const Ray& ray, double tMax) const {
    if (input_.floor) tMax = intersect(*input_.floor, ray, tMax).value_or(tMax);
    BvhHit hit;
    if (input_.obstacle && input_.obstacle->closestHit(ray, hit, 0, tMax)) tMax = hit.t;
    return tMax;
  }

  std::optional<ReflectedHit> sculptureAlong(const Ray& ray, double length) const {
    BvhHit hit;
    if (!input_.sculptureBvh->closestHit(ray, hit, 0, length)) return std::nullopt;
    const Sculpture& s = *input_.sculpture;
    const PointArray& points = input_.originalMoved ? moved_ : s.original;
    const Triangle& t = s.mesh.triangles[hit.triangle];
    const Point original = (1 - hit.u - hit.v) * points[t[0]] + hit.u * points[t[1]] + hit.v * points[t[2]];
    return ReflectedHit{s.sourceTriangle[hit.triangle], original};
  }

  const MatchInput& input_;
  Projection projection_;
  PointArray
      moved_;  // of every vertex of the sculpture: where its point of the original is now, if that has moved
};

// Pixels that show the sculpture where neither they nor their neighbours show the original.
std::size_t countBeside(const std::vector<PixelResult>& pixels, int width, int height) {
  const auto original = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < width && y < height &&
           showsOriginal(pixels[static_cast<std::size_t>(y) * width + x].kind);
  };
  std::size_t count = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (pixels[static_cast<std::size_t>(y) * width + x].kind != PixelClass::onlyReflection) continue;
      bool near = false;
      for (int i = 0; i < 9; ++i) near |= original(x + i % 3 - 1, y + i / 3 - 1);
      count += !near;
    }
  }
  return count;
}

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
  report.originalPixels = static_cast<std::size_t>(original);
  if (either > 0) report.silhouetteIou = both / either;
  if (original > 0) {
    report.hiddenShare = of(PixelClass::hidden) / original;
    report.missedShare = of(PixelClass::missed) / original;
    report.extraShare = static_cast<double>(countBeside(pixels, input.width, input.height)) / original;
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
    progress.update(0.8 * static_cast<double>(rowsDone) / static_cast<double>(height));
  });
  if (progress.cancelled()) return {};
  Match match;
  match.report = summarize(pixels, input);
  match.report.foldedShare = input.sculpture->folded.share;
  match.classes.reserve(pixels.size());
  for (const PixelResult& pixel : pixels) match.classes.push_back(pixel.kind);
  const auto classAt = [&](const Pixel& place) { return matcher.at(place).kind(); };
  const Outlines outlines =
      findOutlines(match.classes, input.width, input.height, classAt, threads, progress);
  if (progress.cancelled()) return {};
  match.report.contourPx = contourDistance(outlines.original, outlines.reflection);
  return match;
}

const MatchBounds& boundsOf(MatchGrade grade) {
  static constexpr MatchBounds bounds[] = {
      {MatchGrade::excellent, 0.5, 0.5, 0.995, 0, 0, 0.001},
      {MatchGrade::match, 1, 1, 0.99, 0.01, 0.01, 0.01},
      {MatchGrade::partial, 3, std::numeric_limits<double>::infinity(), 0, 0.5, 0.5, 0.5},
  };
  const auto index = static_cast<std::size_t>(grade);
  CHECK(index < std::size(bounds));
  return bounds[index];
}

MatchGrade gradeOf(const MatchReport& report) {
  const double pixels = static_cast<double>(report.width) * report.height;
  if (static_cast<double>(report.originalPixels) < std::clamp(fewestShare * pixels, fewestPixels, mostNeeded))
    return MatchGrade::tooSmall;
  if (report.comparedPixels == 0) return MatchGrade::none;
  for (const MatchGrade grade : {MatchGrade::excellent, MatchGrade::match, MatchGrade::partial}) {
    const MatchBounds& most = boundsOf(grade);
    if (report.contourPx <= most.contourPx && report.p99Px <= most.p99Px &&
        report.triangleAgreement >= most.triangleAgreement && report.hiddenShare <= most.hiddenShare &&
        report.missedShare <= most.missedShare && report.extraShare <= most.extraShare)
      return grade;
  }
  return MatchGrade::poor;
}

const char* matchGradeName(MatchGrade grade) {
  constexpr const char* names[] = {"excellent", "match", "partial", "poor", "none", "too small"};
  return names[static_cast<int>(grade)];
}

}  // namespace anamorph
