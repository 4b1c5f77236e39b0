// The ellipsoid mirror: three radii along axes of its own. Measured along these, each in its radius, it is the sphere of
// radius 1 about 0, and everything is the sphere's (sphere.h) there.
//
//         .---------.        rows: own axis / radius;  w, u: rows applied to eye - centre and ray
//       (     C----a-)       |w + t u|^2 = 1:  a = u.u,  b = u.w,  c = w.w - 1
//         '---------'        normal: the point of the sphere along the rows, made unit
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "base/language.h"
#include "math/placement.h"
#include "math/quadratic.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct EllipsoidMirror {
  static constexpr const char *name = "ellipsoid", *label = "Ellipsoid";
  static constexpr int since = 2;

  Point centre{0};
  Vector radii{1.5, 1, 1};
  Vector rotationDegrees{0};
  bool operator==(const EllipsoidMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"centre", "Centre"}, centre);
    fields.lengths({"radii", "Radius", "Along each of its own axes."}, {&radii.x, 3});
    fields.angles({"rotationDegrees", "Rotation", "Of its own axes, about x, then y, then z.", false, true},
                  rotationDegrees);
  }

  double smallest() const { return std::min({radii.x, radii.y, radii.z}); }
  double largest() const { return std::max({radii.x, radii.y, radii.z}); }

  // ---- Rays

  /// Its place among spheres of radius 1.
  struct Form {
    explicit Form(const EllipsoidMirror& e) {
      const glm::dmat3 own = rotationMatrix(e.rotationDegrees);
      for (int i = 0; i < 3; ++i) rows[static_cast<std::size_t>(i)] = own[i] / e.radii[i];
    }
    /// A vector in radii along the own axes.
    [[gnu::always_inline]] Vector inRadii(const Vector& v) const {
      return {glm::dot(rows[0], v), glm::dot(rows[1], v), glm::dot(rows[2], v)};
    }
    /// Outwards, of length 1, at a point in radii.
    [[gnu::always_inline]] Vector normalAt(const Vector& p) const {
      const Vector n = p.x * rows[0] + p.y * rows[1] + p.z * rows[2];
      return n * (1 / std::sqrt(glm::dot(n, n)));
    }
    std::array<Vector, 3> rows;
  };
  Form prepare() const { return Form(*this); }

  std::optional<SurfaceHit> intersect(const Form& form, const Ray& ray, double tMin) const {
    const Vector w = form.inRadii(ray.origin - centre), u = form.inRadii(ray.direction);
    const auto roots = solveQuadratic(glm::dot(u, u), glm::dot(u, w), glm::dot(w, w) - 1);
    if (!roots) return std::nullopt;
    for (const double t : {roots->first, roots->second}) {
      if (t > tMin) return SurfaceHit{t, ray.at(t), facing(form.normalAt(w + t * u), ray.direction)};
    }
    return std::nullopt;
  }

  /// In radii from the centre: 1 on the surface.
  double distanceOf(const Form& form, const Point& eye) const {
    return glm::length(form.inRadii(eye - centre));
  }
  bool seesConvexSide(const Point& eye) const { return distanceOf(prepare(), eye) > 1 + shapeTolerance; }

  /// Outside a convex surface the first bounce is the only one.
  struct Bounce {
    Form form;
    Vector w;
    double c;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const Vector u = form.inRadii(v);
      const double t = firstFromOutside(glm::dot(u, u), glm::dot(u, w), c);
      return {t, form.normalAt(w + t * u), t > 0};
    }
  };
  Bounce bounceFrom(const Point& eye) const {
    const Form form = prepare();
    const Vector w = form.inRadii(eye - centre);
    return {form, w, glm::dot(w, w) - 1};
  }

  struct HollowBounce {
    Bounce outside;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const Vector u = outside.form.inRadii(v);
      const auto [near, far, real] = bothRoots(glm::dot(u, u), glm::dot(u, outside.w), outside.c);
      const double t = near > 0 ? near : far;
      return {t, outside.form.normalAt(outside.w + t * u), real};
    }
    [[gnu::always_inline]] bool isFree(double t, const Vector& v, const Vector& onward, double length) const {
      const Vector p = outside.w + t * outside.form.inRadii(v), u = outside.form.inRadii(onward);
      return !isOnTheWay(-2 * glm::dot(p, u) / glm::dot(u, u), length);
    }
  };
  HollowBounce hollowBounceFrom(const Point& eye) const { return {bounceFrom(eye)}; }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const {
    for (int i = 0; i < 3; ++i) {
      if (auto problem = findRadiusProblem(radii[i])) return problem;
    }
    return std::nullopt;
  }
  std::optional<std::string> findEyeProblem(const Form& form, const Point& eye) const {
    if (auto problem = findDistanceProblem(glm::length(eye - centre), smallest())) return problem;
    return findContactProblem(std::abs(distanceOf(form, eye) - 1), 1);
  }
  Point eyeOutside(const Point& eye, const Point& original) const {
    return centre + 2 * largest() * wayOut(eye - centre, centre - original, Direction(0, -1, 0));
  }

  // ---- Its place

  /// Half its size along the scene's axes are the roots of this matrix' diagonal; the part of x and y is its outline
  /// seen from above.
  glm::dmat3 spread() const {
    glm::dmat3 m = rotationMatrix(rotationDegrees);
    for (int i = 0; i < 3; ++i) m[i] *= radii[i];
    return m * glm::transpose(m);
  }
  Box box() const {
    const glm::dmat3 m = spread();
    const Vector half = glm::sqrt(Vector(m[0][0], m[1][1], m[2][2]));
    return {centre - half, centre + half};
  }
  Point middle() const { return centre; }
  Axes axes() const {
    const glm::dmat3 own = rotationMatrix(rotationDegrees);
    return {own[0], own[1], own[2]};
  }
  ShapeExtent extent() const { return {centre, axes()[2], 2 * std::max(radii.x, radii.y), 2 * radii.z}; }
  /// Half as far from the middle as the eye at most.
  static EllipsoidMirror filling(const ShapeExtent& e, const Point& eye) {
    const Axes own = axesAlong(e.up);
    const Vector rotation = eulerDegrees({own[0], own[1], own[2]}, Vector(0));
    EllipsoidMirror made{e.middle, 0.5 * Vector(e.width, e.width, e.height), rotation};
    const double distance = made.distanceOf(made.prepare(), eye);
    if (distance > 1e-6) made.radii *= std::min(1.0, 0.5 * distance);
    return made;
  }
  void map(const ShapeMap& map) {
    const Axes own = axes();
    glm::dmat3 turned;
    for (int i = 0; i < 3; ++i) turned[i] = turnedBy(map, centre, own[static_cast<std::size_t>(i)]);
    if (turned != glm::dmat3(own[0], own[1], own[2])) rotationDegrees = eulerDegrees(turned, rotationDegrees);
    for (int i = 0; i < 3; ++i) radii[i] = map.size(radii[i], map.factors[i]);
    centre = map.point(centre);
  }
  void carryOn() { radii *= 1.05; }

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const {
    const double angle = 2 * pi * u, height = pi * (v - 0.5);
    const Vector onSphere(std::cos(height) * std::cos(angle), std::cos(height) * std::sin(angle),
                          std::sin(height));
    return centre + rotationMatrix(rotationDegrees) * (radii * onSphere);
  }
  std::array<int, 2> gridFor(int segments) const { return {segments, (segments + 1) / 2}; }
  SurfaceLines lines() const { return {16, 8, true, 48, 24, {}, {0.5}}; }
  std::optional<double> circleFromAbove() const {
    const glm::dmat3 m = spread();
    const double tolerance = 1e-9 * (m[0][0] + m[1][1]);
    const bool isCircle = std::abs(m[0][0] - m[1][1]) < tolerance && std::abs(m[0][1]) < tolerance;
    return isCircle ? std::optional(std::sqrt(m[0][0])) : std::nullopt;
  }
  double borderDistance(const Point&) const { return 1; }

  // 0: centre; 1..3: own axis, radius along it.
  PackedShape packed(const Point& origin) const {
    const Axes own = axes();
    PackedShape data{glm::dvec4(centre - origin, 0)};
    for (std::size_t i = 0; i < 3; ++i) data[i + 1] = {own[i], radii[static_cast<int>(i)]};
    return data;
  }

  ShapeWords words(LengthText text) const {
    const Vector& turn = rotationDegrees;
    return {trFormat("An ellipsoid of {} x {} x {} mm along its own axes. ", text(2 * radii.x),
                     text(2 * radii.y), text(2 * radii.z)),
            turn == Vector(0) ? tr("Straight over the blue outline")
                              : trFormat("Over the blue outline, turned by {:.1f}, {:.1f} and {:.1f} degrees "
                                         "about x, then y, then z",
                                         turn.x, turn.y, turn.z)};
  }
};

}  // namespace anamorph
