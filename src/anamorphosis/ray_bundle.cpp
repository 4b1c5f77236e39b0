#include "anamorphosis/ray_bundle.h"

#include <algorithm>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "math/frame.h"

namespace anamorph {
namespace {

constexpr double edgeOnShare = 0.05;  // of its longest edge squared: flatter bundles are seen edge-on
// On the axis of a ball both focal points are one, and rounding makes them complex: so much below 0, in b^2, is 0.
constexpr double doubleFocus = 0.05;

}  // namespace

std::optional<ExitRay> exitRayTowards(const VertexMap& map, const Point& target) {
  const Vector towards = target - map.eye;
  const double length = glm::length(towards);
  if (!(length > 0)) return std::nullopt;
  const OpticPath path = followRay(map.optic, {map.eye, towards});
  if (path.pointCount == 0) return std::nullopt;
  return ExitRay{towards / length, path.exit.origin, glm::normalize(path.exit.direction),
                 exitLength(map, path, towards) * length};
}

RayBundle::Side RayBundle::between(const ExitRay& from, const ExitRay& to) {
  return {to.sent - from.sent, to.exit - from.exit, to.onward - from.onward};
}

RayBundle::RayBundle(const Side& one, const Side& other, const Direction& sent, const Direction& onward,
                     double distance)
    : atEye_(glm::dot(sent, glm::cross(one.sent, other.sent))),
      distance_(distance),
      constant_(glm::dot(glm::cross(one.exit, other.exit), onward)),
      linear_(glm::dot(glm::cross(one.exit, other.onward) + glm::cross(one.onward, other.exit), onward)),
      square_(glm::dot(glm::cross(one.onward, other.onward), onward)) {
  const double longest =
      std::max({lengthSquared(one.sent), lengthSquared(other.sent), lengthSquared(other.sent - one.sent)});
  edgeOn_ = !(std::abs(atEye_) >= edgeOnShare * longest);
}

RayBundle::RayBundle(const std::array<ExitRay, 3>& rays)
    : RayBundle(between(rays[0], rays[1]), between(rays[0], rays[2]), rays[0].sent,
                glm::normalize(rays[0].onward + rays[1].onward + rays[2].onward),
                (rays[0].distance + rays[1].distance + rays[2].distance) / 3) {}

double RayBundle::spread(double distance) const {
  const double there = constant_ + distance * (linear_ + distance * square_);
  return atEye_ < 0 ? -there : there;
}

std::vector<double> RayBundle::foci() const {
  std::vector<double> found;
  const auto add = [&](double distance) {
    if (distance > 0 && std::isfinite(distance)) found.push_back(distance);
  };
  const double a = square_, b = 0.5 * linear_, c = constant_, discriminant = b * b - a * c;
  if (std::abs(discriminant) <= doubleFocus * b * b && discriminant < 0) {
    add(-b / a);
    add(-b / a);
  } else if (discriminant >= 0) {
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0) add(q / a);
    if (q != 0) add(c / q);
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<RayBundle> bundleAround(const VertexMap& map, const ExitRay& ray, const Point& target,
                                      double step) {
  const double away = step * glm::length(target - map.eye);
  const Direction x = perpendicular(ray.sent), y = glm::cross(ray.sent, x);
  std::array<RayBundle::Side, 2> sides;
  for (std::size_t i = 0; i < 2; ++i) {
    const Vector aside = away * (i == 0 ? x : y);
    const auto before = exitRayTowards(map, target - aside), after = exitRayTowards(map, target + aside);
    if (!before || !after) return std::nullopt;
    sides[i] = RayBundle::between(*before, *after);
  }
  return RayBundle(sides[0], sides[1], ray.sent, ray.onward, ray.distance);
}

std::optional<RayBundle> bundleAround(const VertexMap& map, const Point& target, double step) {
  const auto ray = exitRayTowards(map, target);
  return ray ? bundleAround(map, *ray, target, step) : std::nullopt;
}

}  // namespace anamorph
