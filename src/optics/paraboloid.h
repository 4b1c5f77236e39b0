// The paraboloid mirror: the bowl rho^2 = 4 f h about an axis, from the vertex to its rim; it may have a round hole in the
// middle. Rays from its focus, f above the vertex, leave it parallel to the axis.
//
//      \         /  rim     w, u: eye and ray across the axis;  hE, hV: along it
//       \   F   /           |w + t u|^2 = 4 f (hE + t hV):
//        '.___.'            a = u.u,  b = u.w - 2 f hV,  c = w.w - 4 f hE
//          V                a = 0 along the axis: one root
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "base/language.h"
#include "math/quadratic.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct ParaboloidMirror {
  static constexpr const char *name = "paraboloid", *label = "Paraboloid";
  static constexpr int since = 2;

  Point vertex{0};
  Vector axis{0, -1, 0};  ///< of any length > 0, out of the bowl
  double focalLength = 2;
  double radius = 2;
  double innerRadius = 0;
  bool operator==(const ParaboloidMirror&) const = default;

  void visitFields(ShapeFields& fields) {
    fields.point({"vertex", "Vertex", "The deepest point of the bowl."}, vertex);
    fields.direction({"axis", "Axis", "Where the bowl opens to."}, axis);
    fields.length({"focalLength", "Focal length", "From the vertex to the focus."}, focalLength);
    fields.length({"radius", "Radius", "Of the rim."}, radius);
    fields.length({"innerRadius", "Inner radius", "Of a hole in the middle; 0: there is none.", true, true},
                  innerRadius);
  }

  Direction unitAxis() const { return glm::normalize(axis); }
  /// Above the vertex, where the surface is this far from the axis.
  double heightAt(double rho) const { return rho * rho / (4 * focalLength); }
  double depth() const { return heightAt(radius); }

  // ---- Rays

  struct Form {
    Form(const ParaboloidMirror& p, const Point& eye)
        : axis(p.unitAxis()),
          w(across(eye - p.vertex)),
          along(glm::dot(eye - p.vertex, axis)),
          twiceFocal(2 * p.focalLength),
          c(glm::dot(w, w) - 2 * twiceFocal * along),
          smallest(p.innerRadius * p.innerRadius),
          largest(p.radius * p.radius) {}

    /// The part of a vector perpendicular to the axis.
    [[gnu::always_inline]] Vector across(const Vector& v) const { return v - glm::dot(v, axis) * axis; }

    struct Coefficients {
      double a, b;
    };
    [[gnu::always_inline]] Coefficients coefficients(const Vector& v, const Vector& u) const {
      return {glm::dot(u, u), glm::dot(u, w) - twiceFocal * glm::dot(v, axis)};
    }
    /// Whether a point of the whole bowl, this far across the axis, is on the finite surface; `margin` is a squared
    /// length. The height would say so less exactly, at the vertex above all.
    [[gnu::always_inline]] bool contains(const Vector& q, double margin = 0) const {
      const double squared = glm::dot(q, q);
      return (squared >= smallest - margin) & (squared <= largest + margin);
    }
    /// Outwards, of length 1, where the surface is this far across the axis.
    [[gnu::always_inline]] Vector normalAt(const Vector& q) const {
      const Vector n = q - twiceFocal * axis;
      return n * (1 / std::sqrt(glm::dot(n, n)));
    }

    /// From the eye to the whole bowl, where it is near.
    double distanceToBowl() const {
      return std::abs(c) / (2 * std::sqrt(glm::dot(w, w) + twiceFocal * twiceFocal));
    }

    Direction axis;
    Vector w;
    double along, twiceFocal, c;
    double smallest, largest;  // rho^2 at hole and rim
  };

  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const {
    const Form form(*this, ray.origin);
    const Vector u = form.across(ray.direction);
    const auto [a, b] = form.coefficients(ray.direction, u);
    const auto roots = solveAnyQuadratic(a, b, form.c);
    if (!roots) return std::nullopt;
    for (const double t : {roots->first, roots->second}) {
      const Vector q = form.w + t * u;
      if (!(t > tMin) || !std::isfinite(t) || !form.contains(q)) continue;
      return SurfaceHit{t, ray.at(t), facing(form.normalAt(q), ray.direction)};
    }
    return std::nullopt;
  }

  /// Outside, and neither over the rim nor through the hole is anything of the inside to be seen.
  bool seesConvexSide(const Point& eye) const {
    const Form form(*this, eye);
    const bool isOutside = form.c > 0 && form.distanceToBowl() > shapeTolerance * radius;
    return isOutside && form.along <= depth() && (innerRadius == 0 || form.along >= heightAt(innerRadius));
  }

  /// Outside a convex surface the first bounce is the only one.
  struct Bounce {
    Form form;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const Vector u = form.across(v);
      const auto [a, b] = form.coefficients(v, u);
      const double t = firstFromOutside(a, b, form.c);
      const Vector q = form.w + t * u;
      return {t, form.normalAt(q), form.contains(q)};
    }
  };
  Bounce bounceFrom(const Point& eye) const { return {Form(*this, eye)}; }

  struct HollowBounce {
    Form form;

    [[gnu::always_inline]] BouncePoint operator()(const Point&, const Vector& v) const {
      const Vector u = form.across(v);
      const auto [a, b] = form.coefficients(v, u);
      const auto [near, far, real] = bothRoots(a, b, form.c);
      const bool nearMeets = (near > 0) & form.contains(form.w + near * u);
      const double t = select(nearMeets, near, far);
      const Vector q = form.w + t * u;
      const bool meets = real & form.contains(q);
      return {t, form.normalAt(q), meets};
    }
    [[gnu::always_inline]] bool isFree(double t, const Vector& v, const Vector& onward, double length) const {
      const Vector q = form.w + t * form.across(v), u = form.across(onward);
      const double b = glm::dot(q, u) - form.twiceFocal * glm::dot(onward, form.axis);
      const double again = -2 * b / glm::dot(u, u);
      return !(isOnTheWay(again, length) & form.contains(q + again * u, 1e-6 * form.largest));
    }
  };
  HollowBounce hollowBounceFrom(const Point& eye) const { return {Form(*this, eye)}; }

  // ---- What can be wrong

  std::optional<std::string> findProblem() const {
    if (!(glm::length(axis) > 0)) return tr("expected an axis that is not 0");
    if (!(focalLength > 0)) return trFormat("expected a focal length > 0, got {}", focalLength);
    if (auto problem = findRadiusProblem(radius)) return problem;
    if (innerRadius >= 0 && innerRadius < radius) return std::nullopt;
    return trFormat("expected an inner radius from 0 to below the radius {}, got {}", radius, innerRadius);
  }
  std::optional<std::string> findEyeProblem(const Point& eye) const {
    const Form form(*this, eye);
    if (auto problem = findDistanceProblem(glm::length(eye - vertex), radius)) return problem;
    const double rho = glm::length(form.w);
    const double beside = std::max({innerRadius - rho, rho - radius, 0.0});  // hole or rim
    return findContactProblem(std::max(beside, form.distanceToBowl()), radius);
  }
  /// On its axis, before the bowl or behind it.
  Point eyeOutside(const Point&, const Point& original) const {
    const double before = glm::dot(original - vertex, axis) > 0 ? -1 : 1;
    return middle() + before * 2 * std::max(radius, depth()) * unitAxis();
  }

  // ---- Its place

  /// A rim, a hole's border, or where the bowl's own slope is that of a side of the box.
  Box box() const {
    const Direction n = unitAxis();
    Vector low(0), high(0);
    for (int i = 0; i < 3; ++i) {
      const double across = std::sqrt(std::max(0.0, 1 - n[i] * n[i]));
      const auto farthest = [&](double along) {  // of rho across + h along
        const double level = along < 0 ? -2 * focalLength * across / along : radius;
        const double rho = std::clamp(level, innerRadius, std::max(innerRadius, radius));
        return rho * across + heightAt(rho) * along;
      };
      low[i] = -farthest(-n[i]);
      high[i] = farthest(n[i]);
    }
    return {vertex + low, vertex + high};
  }
  Point middle() const { return vertex + 0.5 * depth() * unitAxis(); }
  Axes axes() const { return axesAlong(unitAxis()); }
  /// As a plate of its rim's size that stands as upright as it can.
  ShapeExtent extent() const {
    const Direction n = unitAxis();
    const Vector up = Vector(0, 0, 1) - n.z * n;
    const bool lies = !(glm::length(up) > 1e-6);
    return {middle(), lies ? perpendicular(n) : glm::normalize(up), 2 * radius, 2 * radius};
  }
  /// A shallow one that bulges towards the eye.
  static ParaboloidMirror filling(const ShapeExtent& e, const Point& eye) {
    const Vector away = e.middle - eye, flat = away - glm::dot(away, e.up) * e.up;
    const double size = 0.5 * std::min(e.width, e.height), distance = glm::length(away);
    ParaboloidMirror made;
    made.axis = glm::length(flat) > 1e-6 ? glm::normalize(flat) : perpendicular(e.up);
    made.radius = made.focalLength = distance > 1e-6 ? std::min(size, 0.5 * distance) : size;
    made.vertex = e.middle - 0.5 * made.depth() * made.axis;
    return made;
  }
  void map(const ShapeMap& map) {
    const double wider = map.size(radius, {map.factors.x, map.factors.y}), widened = wider / radius;
    const double deepened = map.size(depth(), map.factors.z) / depth();
    focalLength = map.size(focalLength, widened * widened / deepened);
    radius = wider;
    innerRadius *= widened;
    axis = turnedBy(map, vertex, axis);
    vertex = map.point(vertex);
  }
  void carryOn() {
    constexpr double far = 30;  // radii: 900 times as deep
    vertex -= 0.05 * radius * unitAxis();
    radius *= far;
    innerRadius = 0;
  }

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const {
    const double rho = (1 - v) * innerRadius + v * radius;
    return vertex + heightAt(rho) * unitAxis() + rho * around(unitAxis(), u);
  }
  std::array<int, 2> gridFor(int segments) const { return {segments, segments / 4 + 1}; }
  SurfaceLines lines() const { return {16, 4, true, 48, 12, {}, {0, 1}}; }
  std::optional<double> circleFromAbove() const {
    return isUpright(axis) ? std::optional(radius) : std::nullopt;
  }
  double borderDistance(const Point& p) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    const double rho = glm::length(Form(*this, p).w);
    return std::min(radius - rho, innerRadius > 0 ? rho - innerRadius : none) / (2 * radius);
  }

  // 0: vertex, radius; 1: axis, focal length; 2: inner radius.
  PackedShape packed(const Point& origin) const {
    return {glm::dvec4(vertex - origin, radius), glm::dvec4(unitAxis(), focalLength),
            glm::dvec4(innerRadius, 0, 0, 0)};
  }

  ShapeWords words(LengthText text) const {
    std::string size = trFormat("A parabolic bowl of {} mm diameter, {} mm deep, its focal length {} mm. ",
                                text(2 * radius), text(depth()), text(focalLength));
    if (innerRadius > 0) size += trFormat("A hole of {} mm diameter in its middle. ", text(2 * innerRadius));
    if (isUpright(axis)) {
      return {size, axis.z > 0 ? tr("Open to above, its rim over the blue circle")
                               : tr("Open to below, its rim over the blue circle")};
    }
    return {size, trFormat("Over the blue outline, its open side {:.1f} degrees up from the horizontal",
                           degrees(std::asin(unitAxis().z)))};
  }
};

}  // namespace anamorph
