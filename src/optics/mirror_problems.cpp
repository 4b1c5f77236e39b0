// What makes a mirror unusable, said so that a student knows what to do.

#include <algorithm>

#include <fmt/format.h>

#include "base/language.h"
#include "optics/mirror_shapes.h"
#include "optics/round_mirrors.h"

namespace anamorph {
namespace {

using Problem = std::optional<std::string>;

// Of the mirror's size: flatter than this, or nearer than this, counts as zero.
constexpr double tolerance = 1e-6;
// In radii: from farther away too few digits are left to say where on the mirror a ray arrives.
constexpr double farthestEye = 1e6;

Problem shapeProblem(const PlaneMirror& plane) {
  const auto& v = plane.corners;
  const double size = std::max(glm::length(v[2] - v[0]), glm::length(v[3] - v[1]));
  const double area = glm::length(glm::cross(v[2] - v[0], v[3] - v[1])) / 2;
  if (!(area > tolerance * size * size) || !(size > 0)) {
    return tr("expected four corners that span an area, got a quad of area 0");
  }
  const Direction normal = planeNormal(plane);
  const double gap = std::abs(glm::dot(v[1] - v[0], normal));
  if (gap > tolerance * size) {
    return fmt::format(fmt::runtime(tr("expected four corners in one plane, got one that is {:.3g} off it")),
                       gap);
  }
  for (int i = 0; i < 4; ++i) {
    const Vector edge = v[(i + 1) % 4] - v[i], next = v[(i + 2) % 4] - v[(i + 1) % 4];
    if (glm::dot(glm::cross(edge, next), normal) < 0) {
      return tr(
          "expected a convex quad with its corners in order around it, got one whose edges cross or bend "
          "inwards");
    }
  }
  return std::nullopt;
}

Problem shapeProblem(const CylinderMirror& cylinder) {
  if (!(cylinder.radius > 0))
    return fmt::format(fmt::runtime(tr("expected a radius > 0, got {}")), cylinder.radius);
  if (!(glm::length(cylinder.top - cylinder.bottom) > 0)) {
    return tr("expected a top that is not at the bottom, got a cylinder of height 0");
  }
  return std::nullopt;
}

Problem shapeProblem(const SphereMirror& sphere) {
  if (!(sphere.radius > 0))
    return fmt::format(fmt::runtime(tr("expected a radius > 0, got {}")), sphere.radius);
  return std::nullopt;
}

Problem tooFar(double distance, double radius) {
  return fmt::format(
      fmt::runtime(tr("the mirror's radius {:.3g} is too small for an eye that is {:.3g} away: nothing could "
                      "be seen in it. Make the radius larger, or move the eye nearer.")),
      radius, distance);
}

Problem eyeProblem(const PlaneMirror& plane, const Point& eye) {
  const auto& v = plane.corners;
  const double size = std::max(glm::length(v[2] - v[0]), glm::length(v[3] - v[1]));
  if (std::abs(glm::dot(eye - v[0], planeNormal(plane))) > tolerance * size) return std::nullopt;
  return tr(
      "the eye lies in the plane of the mirror, so it sees the mirror edge-on and nothing in it. Move the "
      "eye away from that plane.");
}

Problem eyeProblem(const CylinderMirror& cylinder, const Point& eye) {
  const double distance = glm::length(CylinderForm(cylinder, eye).w);
  if (distance > cylinder.radius * farthestEye) return tooFar(distance, cylinder.radius);
  if (distance > cylinder.radius * (1 + tolerance)) return std::nullopt;
  return fmt::format(
      fmt::runtime(tr("the eye is inside the cylinder (continued beyond its ends): it is {:.3g} from the "
                      "axis and the radius is {:.3g}. From there no ray meets the outside of the mirror. "
                      "Move the eye away from the axis, or make the radius smaller.")),
      distance, cylinder.radius);
}

Problem eyeProblem(const SphereMirror& sphere, const Point& eye) {
  const double distance = glm::length(eye - sphere.centre);
  if (distance > sphere.radius * farthestEye) return tooFar(distance, sphere.radius);
  if (distance > sphere.radius * (1 + tolerance)) return std::nullopt;
  return fmt::format(fmt::runtime(tr("the eye is inside the sphere: it is {:.3g} from the centre and the "
                                     "radius is {:.3g}. From there no ray meets the outside of the mirror. "
                                     "Move the eye away from the centre, or make the radius smaller.")),
                     distance, sphere.radius);
}

}  // namespace

Problem findShapeProblem(const MirrorShape& shape) {
  return std::visit([](const auto& surface) { return shapeProblem(surface); }, shape);
}

Problem findEyeProblem(const MirrorShape& shape, const Point& eye) {
  return std::visit([&](const auto& surface) { return eyeProblem(surface, eye); }, shape);
}

}  // namespace anamorph
