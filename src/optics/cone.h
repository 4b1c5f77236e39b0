// The cone mirror: the side of a cone between two centres, open at both ends; one end may be a point.
//
//       .-top-.         rho = bottomRadius + slope * height (conical_form.h), where that is > 0:
//      /   |   \        the other nappe of the double cone is no mirror
//     '-bottom--'
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/language.h"
#include "optics/conical_form.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct ConeMirror {
  static constexpr const char *name = "cone", *label = "Cone";

  Point bottom{0, 0, 0};
  Point top{0, 0, 1};
  double bottomRadius = 1;
  double topRadius = 0.3;
  bool operator==(const ConeMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"bottom", "Bottom", "The lower end of the axis."}, bottom);
    fields.point({"top", "Top", "The upper end of the axis."}, top);
    fields.length({"bottomRadius", "Bottom radius", "0 makes this end a point.", true}, bottomRadius);
    fields.length({"topRadius", "Top radius", "0 makes this end a point.", true}, topRadius);
    fields.distance({"", "Height", "The bottom stays where it is."}, bottom, top);
  }

  double height() const { return glm::length(top - bottom); }
  Direction axis() const { return glm::normalize(top - bottom); }
  double widest() const { return std::max(bottomRadius, topRadius); }

  // ---- Rays

  using Form = ConicalForm<true>;
  Form formFrom(const Point& eye) const { return {bottom, top, bottomRadius, topRadius, eye}; }

  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const {
    return intersectConical(formFrom(ray.origin), ray, tMin);
  }

  /// A ray may meet the other nappe first, so both crossings are asked. Met from outside, the nappe is convex: the
  /// first bounce is the only one.
  struct Bounce {
    Form form;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const Vector u = form.across(v);
      const auto [a, b] = form.coefficients(v, u);
      const auto [near, far, real] = bothRoots(a, b, form.c);
      const bool nearMeets = (near > 0) & form.contains(near, v);
      const double t = select(nearMeets, near, far);
      const bool fromOutside = a * t + b < 0;  // where the quadric's value falls
      const bool meets = real & form.contains(t, v) & fromOutside;
      return {t, form.normalAt(t, v, u), meets};
    }
  };
  Bounce bounceFrom(const Point& eye) const { return {formFrom(eye)}; }
  HollowConicalBounce<true> hollowBounceFrom(const Point& eye) const { return {formFrom(eye)}; }
  bool seesConvexSide(const Point& eye) const {
    const Form form = formFrom(eye);
    return form.seesOutsideOnly(form.along < 0 ? bottomRadius : topRadius);
  }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const {
    for (const double radius : {bottomRadius, topRadius}) {
      if (radius >= 0) continue;
      return trFormat("expected a radius of 0 or more, got {}", radius);
    }
    if (!(widest() > 0)) return tr("expected a bottom or a top radius > 0, got a cone of width 0");
    if (!(height() > 0)) return tr("expected a top that is not at the bottom, got a cone of height 0");
    return std::nullopt;
  }
  std::optional<std::string> findEyeProblem(const Point& eye) const {
    const Form form = formFrom(eye);
    if (auto problem = findDistanceProblem(glm::length(eye - middle()), widest())) return problem;
    return findContactProblem(form.distanceToSurface(), widest());
  }
  Point eyeOutside(const Point& eye, const Point& original) const {
    const Form form = formFrom(eye);
    const double far = 0.1 * farthestEye * widest();
    const double along = std::clamp(form.along, -far, far);
    const double reach = 2 * std::max(widest(), bottomRadius + form.slope * along);
    return bottom + along * form.axis +
           reach * wayOut(form.w, form.across(bottom - original), perpendicular(form.axis));
  }

  // ---- Its place

  Box box() const { return boxOfDiscs(bottom, bottomRadius, top, topRadius); }
  Point middle() const { return 0.5 * (bottom + top); }
  Axes axes() const { return axesAlong(axis()); }
  ShapeExtent extent() const { return {middle(), axis(), 2 * widest(), height()}; }
  static ConeMirror filling(const ShapeExtent& e, const Point& eye) {
    constexpr double narrowing = 0.3;
    const Vector half = 0.5 * e.height * e.up;
    const double r = fillingRadius(e, eye, narrowing);
    return {e.middle - half, e.middle + half, r, narrowing * r};
  }
  void map(const ShapeMap& map) {
    for (double* radius : {&bottomRadius, &topRadius}) {
      if (*radius > 0) *radius = map.size(*radius, {map.factors.x, map.factors.y});  // a point stays one
    }
    bottom = map.point(bottom);
    top = map.point(top);
  }
  /// To its apex, and far beyond its wider end.
  void carryOn() {
    constexpr double far = 1e3;  // heights
    const Vector along = top - bottom;
    const double growth = topRadius - bottomRadius;
    const double below = growth > 0 ? std::min(far, bottomRadius / growth) : far;
    const double above = growth < 0 ? std::min(far, topRadius / -growth) : far;
    bottom -= below * along;
    top += above * along;
    bottomRadius = 1.05 * std::max(0.0, bottomRadius - below * growth);
    topRadius = 1.05 * std::max(0.0, topRadius + above * growth);
  }

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const {
    const double radius = (1 - v) * bottomRadius + v * topRadius;
    return glm::mix(bottom, top, v) + radius * around(axis(), u);
  }
  std::array<int, 2> gridFor(int segments) const { return {segments, 1}; }
  SurfaceLines lines() const { return {16, 4, true, 48, 1, {}, {0, 1}}; }
  std::optional<double> circleFromAbove() const {
    return isUpright(top - bottom) ? std::optional(widest()) : std::nullopt;
  }
  double borderDistance(const Point& p) const {
    constexpr double none = std::numeric_limits<double>::infinity();  // a point is no border
    const double along = glm::dot(p - bottom, axis());
    const double nearest = std::min(bottomRadius > 0 ? along : none, topRadius > 0 ? height() - along : none);
    return nearest / std::max(height(), 2 * widest());
  }

  bool standsOnNarrowEnd() const {
    return isUpright(top - bottom) && (topRadius - bottomRadius) * (top - bottom).z > 0;
  }

  // 0: bottom, its radius; 1: axis, height; 2: slope, top radius.
  PackedShape packed(const Point& origin) const {
    const double slope = (topRadius - bottomRadius) / height();
    return {glm::dvec4(bottom - origin, bottomRadius), glm::dvec4(axis(), height()),
            glm::dvec4(slope, topRadius, 0, 0)};
  }

  ShapeWords words(LengthText text) const {
    return {trFormat("A cone of {} mm diameter at its bottom, {} mm at its top, {} mm high. ",
                     text(2 * bottomRadius), text(2 * topRadius), text(height())),
            standsOnNarrowEnd() ? tr("Upright on its narrow end, in the middle of the blue circle")
                                : stanceAlong(top - bottom)};
  }
};

}  // namespace anamorph
