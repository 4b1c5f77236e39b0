// The sphere mirror: |w + t u|^2 = r^2, where w is the eye seen from the centre and u the ray.
//
//        E *---- u ---->          t = (-b -+ sqrt(b^2 - a c)) / a,   a = u.u,  b = u.w,  c = w.w - r^2
//           \         _____
//          w \       /     \      (the smaller root as c / q with q = -b + sqrt(...): no cancellation)
//             \_____|   C   |
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/language.h"
#include "math/quadratic.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct SphereMirror {
  static constexpr const char *name = "sphere", *label = "Sphere";
  static constexpr bool isRound = true;

  Point centre{0};
  double radius = 1;
  bool operator==(const SphereMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"centre", "Centre"}, centre);
    fields.length({"radius", "Radius"}, radius);
  }

  // ---- Rays

  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const {
    const Vector w = ray.origin - centre, &u = ray.direction;
    const auto roots = solveQuadratic(glm::dot(u, u), glm::dot(u, w), glm::dot(w, w) - radius * radius);
    if (!roots) return std::nullopt;
    for (const double t : {roots->first, roots->second}) {
      if (t > tMin) return SurfaceHit{t, ray.at(t), facing((w + t * u) * (1 / radius), u)};
    }
    return std::nullopt;
  }

  double distanceOf(const Point& eye) const { return glm::length(eye - centre); }
  bool seesConvexSide(const Point& eye) const { return distanceOf(eye) > radius * (1 + shapeTolerance); }

  /// Outside a convex surface the first bounce is the only one.
  struct Bounce {
    Vector w;
    double c, inverseRadius;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const double t = firstFromOutside(glm::dot(v, v), glm::dot(v, w), c);
      return {t, (w + t * v) * inverseRadius, t > 0};
    }
  };
  Bounce bounceFrom(const Point& eye) const {
    const Vector w = eye - centre;
    return {w, glm::dot(w, w) - radius * radius, 1 / radius};
  }

  struct HollowBounce {
    Bounce outside;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const auto [near, far, real] = bothRoots(glm::dot(v, v), glm::dot(v, outside.w), outside.c);
      const double t = near > 0 ? near : far;
      return {t, (outside.w + t * v) * outside.inverseRadius, real};
    }
    [[gnu::always_inline]] bool isFree(double t, const Vector& v, const Vector& onward, double length) const {
      const double again = -2 * glm::dot(outside.w + t * v, onward) / glm::dot(onward, onward);
      return !isOnTheWay(again, length);
    }
  };
  HollowBounce hollowBounceFrom(const Point& eye) const { return {bounceFrom(eye)}; }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const { return findRadiusProblem(radius); }
  std::optional<std::string> findEyeProblem(const Point& eye) const {
    if (auto problem = findDistanceProblem(distanceOf(eye), radius)) return problem;
    return findContactProblem(std::abs(distanceOf(eye) - radius), radius);
  }
  Point eyeOutside(const Point& eye, const Point& original) const {
    return centre + 2 * radius * wayOut(eye - centre, centre - original, Direction(0, -1, 0));
  }

  // ---- Its place

  Box box() const { return {centre - Vector(radius), centre + Vector(radius)}; }
  Point middle() const { return centre; }
  Axes axes() const { return sceneAxes; }
  ShapeExtent extent() const { return {centre, {0, 0, 1}, 2 * radius, 2 * radius}; }
  static SphereMirror filling(const ShapeExtent& e, const Point& eye) {
    const double size = 0.5 * std::min(e.width, e.height), distance = glm::length(eye - e.middle);
    return {e.middle, distance > 1e-6 ? std::min(size, 0.5 * distance) : size};
  }
  void map(const ShapeMap& map) {
    radius = map.size(radius, {map.factors.x, map.factors.y, map.factors.z});
    centre = map.point(centre);
  }
  void carryOn() { radius *= 1.05; }

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const {
    const double angle = 2 * pi * u, height = pi * (v - 0.5);
    return centre + radius * Vector(std::cos(height) * std::cos(angle), std::cos(height) * std::sin(angle),
                                    std::sin(height));
  }
  std::array<int, 2> gridFor(int segments) const { return {segments, (segments + 1) / 2}; }
  SurfaceLines lines() const { return {16, 8, true, 48, 24, {}, {0.5}}; }
  std::optional<double> circleFromAbove() const { return radius; }
  double borderDistance(const Point&) const { return 1; }

  // 0: centre, radius.
  PackedShape packed(const Point& origin) const { return {glm::dvec4(centre - origin, radius)}; }

  ShapeWords words(LengthText text) const {
    return {trFormat("A ball of {} mm diameter. ", text(2 * radius)),
            tr("Its lowest point over the cross; the blue circle is its outline")};
  }
};

}  // namespace anamorph
