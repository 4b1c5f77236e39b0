#include "optics/mirror_shapes.h"

#include <iterator>

#include "math/quadratic.h"
#include "optics/plane_mirror.h"
#include "optics/round_mirrors.h"

namespace anamorph {
namespace {

Direction facing(const Direction& normal, const Vector& ray) {
  return glm::dot(normal, ray) > 0 ? -normal : normal;
}

// The first root beyond tMin whose point is on the finite surface. Form is SphereForm or CylinderForm.
template <typename Form>
std::optional<SurfaceHit> intersectRound(const Form& form, const Ray& ray, double tMin) {
  const Vector u = form.across(ray.direction);
  const auto hitAt = [&](double t) -> std::optional<SurfaceHit> {
    if (!(t > tMin) || !form.contains(t, ray.direction)) return std::nullopt;
    return SurfaceHit{t, ray.at(t), facing((form.w + t * u) * form.inverseRadius, ray.direction)};
  };
  const auto roots = solveQuadratic(glm::dot(u, u), glm::dot(u, form.w), form.c);
  if (!roots) return std::nullopt;
  const auto first = hitAt(roots->first);
  return first ? first : hitAt(roots->second);
}

}  // namespace

std::optional<SurfaceHit> intersect(const PlaneMirror& plane, const Ray& ray, double tMin) {
  const PlaneForm form(plane);
  const double t = form.distanceFrom(ray.origin) / glm::dot(form.normal, ray.direction);
  if (!(t > tMin) || !std::isfinite(t)) return std::nullopt;
  const Point q = ray.at(t);
  if (!form.contains(q)) return std::nullopt;
  return SurfaceHit{t, q, facing(form.normal, ray.direction)};
}

std::optional<SurfaceHit> intersect(const CylinderMirror& cylinder, const Ray& ray, double tMin) {
  return intersectRound(CylinderForm(cylinder, ray.origin), ray, tMin);
}

std::optional<SurfaceHit> intersect(const SphereMirror& sphere, const Ray& ray, double tMin) {
  return intersectRound(SphereForm(sphere, ray.origin), ray, tMin);
}

std::optional<SurfaceHit> intersect(const MirrorShape& shape, const Ray& ray, double tMin) {
  return std::visit([&](const auto& surface) { return intersect(surface, ray, tMin); }, shape);
}

Direction planeNormal(const PlaneMirror& plane) {
  const auto& v = plane.corners;
  return glm::normalize(glm::cross(v[2] - v[0], v[3] - v[1]));
}

Point middleOf(const PlaneMirror& plane) {
  const auto& v = plane.corners;
  return 0.25 * (v[0] + v[1] + v[2] + v[3]);
}
Point middleOf(const CylinderMirror& cylinder) {
  return 0.5 * (cylinder.bottom + cylinder.top);
}
Point middleOf(const SphereMirror& sphere) {
  return sphere.centre;
}

Point middleOf(const MirrorShape& shape) {
  return std::visit([](const auto& surface) { return middleOf(surface); }, shape);
}

const char* shapeName(const MirrorShape& shape) {
  constexpr const char* names[] = {"plane", "cylinder", "sphere"};
  static_assert(std::size(names) == std::variant_size_v<MirrorShape>);
  return names[shape.index()];
}

}  // namespace anamorph
