// The curved shapes said a second time, in another way than the program does: a function that is 0 on the whole surface,
// less inside and more outside, and how far a point of it is within what is kept of it. For searches that are slow and
// simple.
#pragma once

#include <functional>
#include <limits>
#include <optional>

#include "shapes.h"

namespace anamorph::testing {

struct SurfaceOf {
  std::function<double(const Point&)> value;
  std::function<double(const Point&)> within;  ///< a length; negative where it has ended

  /// Outwards, of length 1, by differences.
  Direction normalAt(const Point& p, double step = 1e-5) const {
    Vector n;
    for (int i = 0; i < 3; ++i) {
      Vector e(0);
      e[i] = step;
      n[i] = value(p + e) - value(p - e);
    }
    return glm::normalize(n);
  }
};

inline double alongAxis(const Point& p, const Point& bottom, const Point& top) {
  return glm::dot(p - bottom, glm::normalize(top - bottom));
}

inline SurfaceOf surfaceOf(const Shape& shape) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  if (const auto* tube = shape.as<CylinderMirror>()) {
    const CylinderMirror t = *tube;
    return surfaceOf(ConeMirror{t.bottom, t.top, t.radius, t.radius});
  }
  if (const auto* found = shape.as<ConeMirror>()) {
    const ConeMirror cone = *found;
    const double height = glm::length(cone.top - cone.bottom);
    return {[=](const Point& p) {
              const double v = alongAxis(p, cone.bottom, cone.top) / height;
              return glm::length(glm::cross(p - cone.bottom, (cone.top - cone.bottom) / height)) -
                     ((1 - v) * cone.bottomRadius + v * cone.topRadius);
            },
            [=](const Point& p) {
              const double along = alongAxis(p, cone.bottom, cone.top);
              return std::min(along, height - along);
            }};
  }
  if (const auto* found = shape.as<EllipsoidMirror>()) {
    const EllipsoidMirror e = *found;
    const glm::dmat3 back = glm::transpose(rotationMatrix(e.rotationDegrees));
    return {[=](const Point& p) { return glm::length(back * (p - e.centre) / e.radii) - 1; },
            [](const Point&) { return endless; }};
  }
  if (const auto* found =
          shape.as<ParaboloidMirror>()) {  // as far from the focus as from a plane behind the vertex
    const ParaboloidMirror bowl = *found;
    const Direction axis = glm::normalize(bowl.axis);
    return {[=](const Point& p) {
              return glm::length(p - bowl.vertex - bowl.focalLength * axis) -
                     (glm::dot(p - bowl.vertex, axis) + bowl.focalLength);
            },
            [=](const Point& p) {
              const double rho = glm::length(glm::cross(p - bowl.vertex, axis));
              return std::min(bowl.radius - rho, bowl.innerRadius > 0 ? rho - bowl.innerRadius : endless);
            }};
  }
  const SphereMirror sphere = shapeAs<SphereMirror>(shape);
  return {[=](const Point& p) { return glm::length(p - sphere.centre) - sphere.radius; },
          [](const Point&) { return endless; }};
}

/// Where a ray crosses the whole surface, up to t = end, in order; found by small steps and halving. Two crossings within
/// one step are missed.
inline std::vector<double> crossingsOf(const SurfaceOf& surface, const Ray& ray, double start, double end,
                                       int steps = 2000) {
  std::vector<double> crossings;
  double from = start, before = surface.value(ray.at(start));
  for (int i = 1; i <= steps; ++i) {
    const double to = start + (end - start) * i / steps, after = surface.value(ray.at(to));
    if ((before < 0) != (after < 0)) {
      double low = from, high = to;
      for (int k = 0; k < 60; ++k) {
        const double middle = 0.5 * (low + high);
        ((surface.value(ray.at(middle)) < 0) == (before < 0) ? low : high) = middle;
      }
      crossings.push_back(0.5 * (low + high));
    }
    from = to;
    before = after;
  }
  return crossings;
}

}  // namespace anamorph::testing
