// The cylinder mirror: the side of a cylinder between two centres; open at both ends.
//
//      .-top-.      The cone's form with no slope (conical_form.h).
//      |  |  |
//      '-bottom
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/language.h"
#include "optics/conical_form.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct CylinderMirror {
  static constexpr const char *name = "cylinder", *label = "Cylinder";

  Point bottom{0, 0, 0};
  Point top{0, 0, 1};
  double radius = 1;
  bool operator==(const CylinderMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"bottom", "Bottom", "The lower end of the axis."}, bottom);
    fields.point({"top", "Top", "The upper end of the axis."}, top);
    fields.length({"radius", "Radius"}, radius);
    fields.distance({"", "Height", "The bottom stays where it is."}, bottom, top);
  }

  Direction axis() const { return glm::normalize(top - bottom); }

  // ---- Rays

  using Form = ConicalForm<false>;
  Form formFrom(const Point& eye) const { return {bottom, top, radius, radius, eye}; }

  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const {
    return intersectConical(formFrom(ray.origin), ray, tMin);
  }

  /// Outside a convex surface the first bounce is the only one.
  struct Bounce {
    Form form;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const Vector u = form.across(v);
      const auto [a, b] = form.coefficients(v, u);
      const double t = firstFromOutside(a, b, form.c);
      return {t, form.normalAt(t, v, u), form.contains(t, v)};
    }
  };
  Bounce bounceFrom(const Point& eye) const { return {formFrom(eye)}; }
  HollowConicalBounce<false> hollowBounceFrom(const Point& eye) const { return {formFrom(eye)}; }
  bool seesConvexSide(const Point& eye) const { return formFrom(eye).seesOutsideOnly(radius); }

  /// As it would be if the cylinder were a sphere about its middle: the published mistake (mistakes.h).
  Direction publishedNormal(const Point& point) const { return glm::normalize(point - middle()); }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const {
    if (auto problem = findRadiusProblem(radius)) return problem;
    if (!(glm::length(top - bottom) > 0)) {
      return tr("expected a top that is not at the bottom, got a cylinder of height 0");
    }
    return std::nullopt;
  }
  std::optional<std::string> findEyeProblem(const Point& eye) const {
    const Form form = formFrom(eye);
    if (auto problem = findDistanceProblem(glm::length(form.w), radius)) return problem;
    return findContactProblem(form.distanceToSurface(), radius);
  }
  Point eyeOutside(const Point& eye, const Point& original) const {
    const Form form = formFrom(eye);
    return bottom + form.along * form.axis +
           2 * radius * wayOut(form.w, form.across(bottom - original), perpendicular(form.axis));
  }

  // ---- Its place

  Box box() const { return boxOfDiscs(bottom, radius, top, radius); }
  Point middle() const { return 0.5 * (bottom + top); }
  Axes axes() const { return axesAlong(axis()); }
  ShapeExtent extent() const { return {middle(), axis(), 2 * radius, glm::length(top - bottom)}; }
  static CylinderMirror filling(const ShapeExtent& e, const Point& eye) {
    const Vector half = 0.5 * e.height * e.up;
    return {e.middle - half, e.middle + half, fillingRadius(e, eye)};
  }
  void map(const ShapeMap& map) {
    radius = map.size(radius, {map.factors.x, map.factors.y});
    bottom = map.point(bottom);
    top = map.point(top);
  }
  void carryOn() {
    constexpr double far = 1e3;
    const Vector along = top - bottom;
    bottom -= far * along;
    top += far * along;
    radius *= 1.05;
  }

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const { return glm::mix(bottom, top, v) + radius * around(axis(), u); }
  std::array<int, 2> gridFor(int segments) const { return {segments, 1}; }
  SurfaceLines lines() const { return {16, 4, true, 48, 1, {}, {0, 1}}; }
  std::optional<double> circleFromAbove() const {
    return isUpright(top - bottom) ? std::optional(radius) : std::nullopt;
  }
  double borderDistance(const Point& p) const {
    const double height = glm::length(top - bottom);
    const double along = glm::dot(p - bottom, (top - bottom) / height);
    return std::min(along, height - along) / std::max(height, 2 * radius);
  }

  // 0: bottom, radius; 1: axis, height.
  PackedShape packed(const Point& origin) const {
    return {glm::dvec4(bottom - origin, radius), glm::dvec4(axis(), glm::length(top - bottom))};
  }

  ShapeWords words(LengthText text) const {
    return {trFormat("A cylinder of {} mm diameter, {} mm high. ", text(2 * radius),
                     text(glm::length(top - bottom))),
            stanceAlong(top - bottom)};
  }
};

}  // namespace anamorph
