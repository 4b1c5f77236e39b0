// The arithmetic of one ray and a round side, cylinder or cone, shared by the single ray and by many rays so that
// both give the same bits. One form for both: rho^2 = (r0 + m h)^2, where rho is the distance from the axis and h
// the height above the bottom. The part across the axis is taken first, so with m = 0 nothing of the height
// enters: the cylinder's numbers are the cylinder's own, and a cone with equal radii loses no digits.
//
//      .--r1--.            w, u: eye and ray across the axis;  rE, rV: r0 + m h at the eye, m times the ray's rise
//     /       \  |         |w + t u|^2 = (rE + t rV)^2:
//    /         \ h         a = u.u - rV^2,  b = u.w - rE rV,  c = w.w - rE^2
//   '-----r0----'          only where r0 + m h > 0: the other nappe of the double cone is no mirror
#pragma once

#include <algorithm>
#include <cmath>

#include "math/quadratic.h"
#include "optics/exit_kernel.h"
#include "optics/shape_helpers.h"

namespace anamorph {

template <bool sloped>
struct ConicalForm {
  ConicalForm(const Point& bottom, const Point& top, double bottomRadius, double topRadius, const Point& eye)
      : height(glm::length(top - bottom)),
        axis((top - bottom) / height),
        along(glm::dot(eye - bottom, axis)),
        w(across(eye - bottom)),
        radius(bottomRadius),
        slope(sloped ? (topRadius - bottomRadius) / height : 0),
        radiusAtEye(sloped ? radius + slope * along : radius),
        c(glm::dot(w, w) - radiusAtEye * radiusAtEye),
        inverseRadius(1 / radius),
        slant(sloped ? 1 / std::sqrt(1 + slope * slope) : 1) {}

  /// The part of a vector perpendicular to the axis.
  [[gnu::always_inline]] Vector across(const Vector& v) const { return v - glm::dot(v, axis) * axis; }

  struct Coefficients {
    double a, b;
  };
  [[gnu::always_inline]] Coefficients coefficients(const Vector& v, const Vector& u) const {
    if constexpr (sloped) {
      const double growth = slope * glm::dot(v, axis);
      return {glm::dot(u, u) - growth * growth, glm::dot(u, w) - radiusAtEye * growth};
    }
    return {glm::dot(u, u), glm::dot(u, w)};
  }

  /// Whether E + t V is between the two ends, and on the nappe that they belong to.
  [[gnu::always_inline]] bool contains(double t, const Vector& v) const {
    const double position = along + t * glm::dot(v, axis);
    const bool between = (position >= 0) & (position <= height);
    if constexpr (sloped) return between & (radius + slope * position > 0);
    return between;
  }

  /// Outwards, of length 1, where E + t V is on the surface.
  [[gnu::always_inline]] Vector normalAt(double t, const Vector& v, const Vector& u) const {
    if constexpr (sloped) {
      const double here = radius + slope * (along + t * glm::dot(v, axis));
      return slant * ((w + t * u) / here - slope * axis);
    }
    return (w + t * u) * inverseRadius;
  }

  double topRadius() const { return radius + slope * height; }
  double widest() const { return std::max(radius, topRadius()); }

  /// From the eye to the finite surface, where it is near; else more than nothing.
  double distanceToSurface() const {
    const double beyond = std::max({-along, along - height, 0.0});
    return std::max(beyond, slant * std::abs(glm::length(w) - radiusAtEye));
  }

  /// Whether the eye sees nothing of the inner wall: it is outside, and the end that it is beyond, of this radius, is a
  /// point; or it looks into that end from within the other nappe, where its rays are steeper than the wall.
  bool seesOutsideOnly(double endRadius) const {
    const double distance = glm::length(w), gap = shapeTolerance * widest();
    if (!(distance > radiusAtEye + gap)) return false;
    const bool besides = along >= 0 && along <= height;
    return besides || endRadius == 0 || distance < -radiusAtEye - gap;
  }

  double height;
  Direction axis;
  double along;  // of the eye, from the bottom
  Vector w;
  double radius;  // at the bottom
  double slope;   // of the radius, a unit of height
  double radiusAtEye;
  double c;
  double inverseRadius;
  double slant;  // cosine of the slope
};

/// The first of the two crossings at t > tMin that is on the finite surface.
template <bool sloped>
std::optional<SurfaceHit> intersectConical(const ConicalForm<sloped>& form, const Ray& ray, double tMin) {
  const Vector u = form.across(ray.direction);
  const auto [a, b] = form.coefficients(ray.direction, u);
  const auto roots = sloped ? solveAnyQuadratic(a, b, form.c) : solveQuadratic(a, b, form.c);
  if (!roots) return std::nullopt;
  for (const double t : {roots->first, roots->second}) {
    if (!(t > tMin) || !std::isfinite(t) || !form.contains(t, ray.direction)) continue;
    return SurfaceHit{t, ray.at(t), facing(form.normalAt(t, ray.direction, u), ray.direction)};
  }
  return std::nullopt;
}

/// Many rays that may meet either wall, and the nappe beyond the apex that is none. From the inner wall a ray may come to
/// the opposite one: there c = 0, and the other root is -2 b / a.
template <bool sloped>
struct HollowConicalBounce {
  ConicalForm<sloped> form;

  [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
    const Vector u = form.across(v);
    const auto [a, b] = form.coefficients(v, u);
    const auto [near, far, real] = bothRoots(a, b, form.c);
    const bool nearMeets = (near > 0) & form.contains(near, v);
    const double t = select(nearMeets, near, far);
    const bool meets = real & form.contains(t, v);
    return {t, form.normalAt(t, v, u), meets};
  }
  [[gnu::always_inline]] bool isFree(double t, const Vector& v, const Vector& onward, double length) const {
    const double margin = 1e-6 * (form.height + form.radius);  // near an end is on the surface
    const Vector q = form.w + t * form.across(v), u = form.across(onward);
    const double position = form.along + t * glm::dot(v, form.axis), rise = glm::dot(onward, form.axis);
    const double growth = form.slope * rise, here = form.radius + form.slope * position;
    const double again = -2 * (glm::dot(u, q) - here * growth) / (glm::dot(u, u) - growth * growth);
    const double there = position + again * rise;
    const bool between = (there >= -margin) & (there <= form.height + margin);
    return !(between & isOnTheWay(again, length));
  }
};

}  // namespace anamorph
