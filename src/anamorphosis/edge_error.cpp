#include "anamorphosis/edge_error.h"

#include <algorithm>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace anamorph {
namespace {

constexpr double longEdgePixels = 32;  // beyond it an S-shaped error could hide from the middle
constexpr double mixedEdgePixels = 1;  // the border of what the mirror shows is found to this
constexpr double unknownError = 1e6;   // where the derivatives degenerate

// The length in the image. With one end behind the camera it has none: then the angle it takes up tells how
// fine it is, so that the part before the camera is found. With both ends there nothing of it is seen: 0.
double imageLength(const Projection& projection, const Point& a, const Point& b) {
  const auto p = projection.pixelOf(a), q = projection.pixelOf(b);
  if (p && q) return glm::length(*q - *p);
  if (!p && !q) return 0;
  const double nearest = std::min(glm::length(a - projection.eye()), glm::length(b - projection.eye()));
  return projection.pixelsPerTangent() * std::min(glm::length(b - a) / std::max(nearest, 1e-300), pi);
}

// The image error of `chord`, a point of the straight edge, that should be the image of `middle`.
double gapPixels(const EdgeJudge& judge, const Point& middle, const Point& mapped, const Point& chord) {
  const Point eye = judge.projection.eye();
  const Frame& frame = judge.projection.frame();
  const double depth = glm::dot(middle - eye, frame.forward);
  if (!(depth > 0)) return 0;  // behind the camera: not in the image
  const double pixel = depth / judge.projection.pixelsPerTangent();
  // A step to each side, so that the map's curvature cancels. Half a pixel is small against anything seen.
  const auto derivative = [&](const Vector& side, Vector& result) {
    const Vector step = 0.5 * pixel * side;
    const MappedPoint plus = mapPoint(judge.map, middle + step);
    const MappedPoint minus = mapPoint(judge.map, middle - step);
    result = plus.point - minus.point;
    return plus.status == PathStatus::mapped && minus.status == PathStatus::mapped;
  };
  glm::dmat3 jacobian;
  if (!derivative(frame.right, jacobian[0]) || !derivative(frame.up, jacobian[1]))
    return 0;  // at the very border
  const OpticPath path = followRay(judge.map.optic, {eye, middle - eye});
  jacobian[2] = path.exit.direction;
  const double determinant = glm::determinant(jacobian);
  if (!(std::abs(determinant) > 0)) return unknownError;
  const Vector shift = glm::inverse(jacobian) * (chord - mapped);
  const double error = std::hypot(shift.x, shift.y);
  return std::isfinite(error) ? error : unknownError;
}

}  // namespace

double edgeErrorPixels(const EdgeJudge& judge, const EdgeEnd& a, const EdgeEnd& b) {
  const double length = imageLength(judge.projection, a.original, b.original);
  const bool endsMapped = a.status == PathStatus::mapped && b.status == PathStatus::mapped;
  double worst = 0;
  int mappedSamples = 0, samples = 0;
  const auto sample = [&](double fraction) {
    const Point middle = glm::mix(a.original, b.original, fraction);
    const MappedPoint mapped = mapPoint(judge.map, middle);
    ++samples;
    if (mapped.status != PathStatus::mapped) return;
    ++mappedSamples;
    if (!endsMapped) return;
    worst =
        std::max(worst, gapPixels(judge, middle, mapped.point, glm::mix(a.sculpture, b.sculpture, fraction)));
  };
  sample(0.5);
  if (length > longEdgePixels) {
    sample(0.25);
    sample(0.75);
  }
  const bool anyMapped =
      a.status == PathStatus::mapped || b.status == PathStatus::mapped || mappedSamples > 0;
  const bool allMapped = endsMapped && mappedSamples == samples;
  if (anyMapped && !allMapped) return length > mixedEdgePixels ? length : 0;
  return std::min(worst,
                  length);  // between its ends an edge strays no further than it is long: refinement ends
}

}  // namespace anamorph
