#include "anamorphosis/match.h"

#include <algorithm>
#include <cmath>

#include "base/parallel_for.h"

namespace anamorph {
namespace {

// A hit on the sculpture by way of the mirror.
struct ReflectedHit {
  std::uint32_t sourceTriangle;
  Point original;
};

struct PixelResult {
  PixelClass kind = PixelClass::background;
  float errorPx = 0;
  bool sameTriangle = false;
};

// Corner numbers that are the same for corners at the same place, so that "touches" works across texture
// seams.
std::vector<Triangle> weldedCorners(const Mesh& mesh) {
  const std::vector<std::uint32_t> vertexOf = weldPositions(mesh).vertexOf;
  std::vector<Triangle> corners = mesh.triangles;
  for (Triangle& t : corners) {
    for (std::uint32_t& corner : t) corner = vertexOf[corner];
  }
  return corners;
}

bool touch(const Triangle& a, const Triangle& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](std::uint32_t corner) { return std::find(b.begin(), b.end(), corner) != b.end(); });
}

class Matcher {
 public:
  Matcher(const MatchInput& input)
      : input_(input),
        projection_(input.camera, input.width, input.height),
        corners_(weldedCorners(*input.original)) {}

  PixelResult pixel(int x, int y) const {
    const Pixel centre(x + 0.5, y + 0.5);
    const Ray ray = projection_.rayThrough(centre);
    BvhHit direct;
    const bool seesOriginal = input_.originalBvh->closestHit(ray, direct);

    const OpticPath path = followRay(input_.optic, ray);
    const bool meetsMirror = path.pointCount > 0;
    BvhHit before;
    const bool hidden =
        input_.sculptureBvh->closestHit(ray, before, 0, meetsMirror ? path.travelled : infinity);
    std::optional<ReflectedHit> reflected;
    if (meetsMirror && !hidden) reflected = followExit(path);

    PixelResult result;
    if (seesOriginal && reflected) {
      result.kind = PixelClass::both;
      const auto seenAt = projection_.pixelOf(reflected->original);
      const double error = seenAt ? glm::length(*seenAt - centre) : worstError();
      result.errorPx = static_cast<float>(std::min(error, worstError()));
      result.sameTriangle = touch(corners_[direct.triangle], corners_[reflected->sourceTriangle]);
    } else if (seesOriginal) {
      result.kind = !meetsMirror ? PixelClass::missed
                    : hidden     ? PixelClass::hidden
                                 : PixelClass::onlyOriginal;
    } else if (reflected) {
      result.kind = PixelClass::onlyReflection;
    }
    return result;
  }

 private:
  double worstError() const { return std::max(projection_.width(), projection_.height()); }

  static constexpr double infinity = std::numeric_limits<double>::infinity();

  std::optional<ReflectedHit> followExit(const OpticPath& path) const {
    const auto again = intersect(input_.optic.shape, path.exit, 1e-9 * path.travelled);
    BvhHit hit;
    if (!input_.sculptureBvh->closestHit(path.exit, hit, 0, again ? again->t : infinity)) return std::nullopt;
    const Sculpture& s = *input_.sculpture;
    const Triangle& t = s.mesh.triangles[hit.triangle];
    const Point original =
        (1 - hit.u - hit.v) * s.original[t[0]] + hit.u * s.original[t[1]] + hit.v * s.original[t[2]];
    return ReflectedHit{s.sourceTriangle[hit.triangle], original};
  }

  const MatchInput& input_;
  Projection projection_;
  std::vector<Triangle> corners_;
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

Match computeMatch(const MatchInput& input, int threads, const Progress& progress) {
  const auto width = static_cast<std::size_t>(input.width), height = static_cast<std::size_t>(input.height);
  const Matcher matcher(input);
  std::vector<PixelResult> pixels(width * height);
  parallelFor(height, 8, threads, [&](std::size_t firstRow, std::size_t lastRow) {
    if (progress.cancelled()) return;
    for (std::size_t y = firstRow; y < lastRow; ++y) {
      for (std::size_t x = 0; x < width; ++x) {
        pixels[y * width + x] = matcher.pixel(static_cast<int>(x), static_cast<int>(y));
      }
    }
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
