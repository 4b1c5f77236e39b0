// The plane mirror: a planar convex quadrilateral.
//
//            v3 ---------- v2         n . (E + t V - v0) = 0,   inside: to the left of all four edges
//             |     Q      |
//            v0 ---------- v1
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "base/language.h"
#include "optics/shape_helpers.h"

namespace anamorph {

struct PlaneMirror {
  static constexpr const char *name = "plane", *label = "Plane";

  std::array<Point, 4> corners{Point(-1, 0, -1), Point(1, 0, -1), Point(1, 0, 1),
                               Point(-1, 0, 1)};  ///< in order
  bool operator==(const PlaneMirror&) const = default;

  /// Unit; undefined for a quad without area.
  Direction normal() const {
    return glm::normalize(glm::cross(corners[2] - corners[0], corners[3] - corners[1]));
  }

  void visitFields(ShapeFields& fields) {
    fields.points({"corners", "Corner", "The four corners have to lie in one plane, in order around it."},
                  corners);
  }

  // ---- Rays

  /// The arithmetic of one ray and the plane, for one ray and for many: both give the same bits.
  struct Form {
    explicit Form(const PlaneMirror& plane) : corner(plane.corners[0]), normal(plane.normal()) {
      for (std::size_t i = 0; i < 4; ++i) {
        inward[i] = glm::cross(normal, plane.corners[(i + 1) % 4] - plane.corners[i]);
        border[i] = glm::dot(inward[i], plane.corners[i]);
      }
    }
    /// From a point to the plane, along the normal. The ray E + t V is there at t = distanceFrom(E) / (normal . V).
    double distanceFrom(const Point& eye) const { return glm::dot(normal, corner - eye); }
    [[gnu::always_inline]] bool contains(const Point& q) const {
      // & instead of && : no branches, so that loops over it vectorise.
      return (glm::dot(inward[0], q) >= border[0]) & (glm::dot(inward[1], q) >= border[1]) &
             (glm::dot(inward[2], q) >= border[2]) & (glm::dot(inward[3], q) >= border[3]);
    }

    Point corner;
    Direction normal;
    std::array<Vector, 4> inward;  // in the plane, perpendicular to each edge
    std::array<double, 4> border;  // inward . q on the edge itself
  };

  std::optional<SurfaceHit> intersect(const Ray& ray, double tMin) const {
    const Form form(*this);
    const double t = form.distanceFrom(ray.origin) / glm::dot(form.normal, ray.direction);
    if (!(t > tMin) || !std::isfinite(t)) return std::nullopt;
    const Point q = ray.at(t);
    if (!form.contains(q)) return std::nullopt;
    return SurfaceHit{t, q, facing(form.normal, ray.direction)};
  }

  struct Bounce {
    Form plane;
    double distance;  // from the eye to the plane

    [[gnu::always_inline]] BouncePoint operator()(const Point& eye, const Vector& v) const {
      const double t = distance / glm::dot(plane.normal, v);
      return {t, plane.normal, plane.contains(eye + t * v)};
    }
  };
  Bounce bounceFrom(const Point& eye) const {
    const Form form(*this);
    return {form, form.distanceFrom(eye)};
  }

  // ---- What can be wrong

  double size() const {
    return std::max(glm::length(corners[2] - corners[0]), glm::length(corners[3] - corners[1]));
  }

  std::optional<std::string> findProblem() const {
    const auto& v = corners;
    const double area = glm::length(glm::cross(v[2] - v[0], v[3] - v[1])) / 2;
    if (!(area > shapeTolerance * size() * size()) || !(size() > 0)) {
      return tr("expected four corners that span an area, got a quad of area 0");
    }
    const Direction n = normal();
    const double gap = std::abs(glm::dot(v[1] - v[0], n));
    if (gap > shapeTolerance * size()) {
      return trFormat("expected four corners in one plane, got one that is {:.3g} off it", gap);
    }
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector edge = v[(i + 1) % 4] - v[i], next = v[(i + 2) % 4] - v[(i + 1) % 4];
      if (glm::dot(glm::cross(edge, next), n) < 0) {
        return tr(
            "expected a convex quad with its corners in order around it, got one whose edges cross or bend "
            "inwards");
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> findEyeProblem(const Point& eye) const {
    if (std::abs(glm::dot(eye - corners[0], normal())) > shapeTolerance * size()) return std::nullopt;
    return tr(
        "the eye lies in the plane of the mirror, so it sees the mirror edge-on and nothing in it. Move the "
        "eye away from that plane.");
  }

  /// Neither side is hollow.
  bool seesConvexSide(const Point&) const { return true; }

  Point eyeOutside(const Point& eye, const Point& original) const {
    const Direction n = normal();
    const double diagonal = glm::length(corners[2] - corners[0]);
    return eye + 0.5 * diagonal * (glm::dot(n, original - corners[0]) > 0 ? -n : n);
  }

  // ---- Its place

  Box box() const {
    Box box;
    for (const Point& corner : corners) box.extend(corner);
    return box;
  }
  Point middle() const { return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]); }

  // x along the first edge, y through the mirror, z up its side: the scene's axes for an upright mirror.
  Axes axes() const {
    const Direction y = -normal();
    const Vector edge = corners[1] - corners[0];
    const Direction x = glm::normalize(edge - glm::dot(edge, y) * y);
    return {x, y, glm::cross(x, y)};
  }

  ShapeExtent extent() const {
    const auto& v = corners;
    const Vector across = 0.5 * (v[1] - v[0] + v[2] - v[3]), along = 0.5 * (v[3] - v[0] + v[2] - v[1]);
    // The side that is more upright is the height.
    const bool turned = std::abs(glm::normalize(across).z) > std::abs(glm::normalize(along).z);
    const Vector up = turned ? across : along, side = turned ? along : across;
    return {middle(), glm::normalize(up.z < 0 ? -up : up), glm::length(side), glm::length(up)};
  }
  /// Turned towards the eye.
  static PlaneMirror filling(const ShapeExtent& e, const Point& eye) {
    const Vector towards = eye - e.middle, flat = towards - glm::dot(towards, e.up) * e.up;
    const Direction n = glm::length(flat) > 1e-9 ? glm::normalize(flat) : perpendicular(e.up);
    const Vector x = 0.5 * e.width * glm::cross(e.up, n), y = 0.5 * e.height * e.up;
    return {{e.middle - x - y, e.middle + x - y, e.middle + x + y, e.middle - x + y}};
  }

  void map(const ShapeMap& map) {
    for (Point& corner : corners) corner = map.point(corner);
  }
  void carryOn() {
    constexpr double far = 1e3;
    const Point centre = middle();
    for (Point& corner : corners) corner = centre + far * (corner - centre);
  }

  // ---- How it is drawn and described

  Point pointAt(double u, double v) const {
    return glm::mix(glm::mix(corners[0], corners[1], u), glm::mix(corners[3], corners[2], u), v);
  }
  std::array<int, 2> gridFor(int) const { return {1, 1}; }
  SurfaceLines lines() const { return {8, 8, false, 1, 1, {0, 1}, {0, 1}}; }

  double borderDistance(const Point& p) const {
    double nearest = std::numeric_limits<double>::infinity(), longest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = corners[i], &b = corners[(i + 1) % 4];
      const Vector edge = b - a;
      const double squared = lengthSquared(edge);
      const double s = squared > 0 ? std::clamp(glm::dot(p - a, edge) / squared, 0.0, 1.0) : 0;
      nearest = std::min(nearest, glm::length(p - (a + s * edge)));
      longest = std::max(longest, glm::length(edge));
    }
    return nearest / longest;
  }

  // 0: corner; 1: normal, longest edge; 2..5: inward and its distance, of each edge.
  PackedShape packed(const Point& origin) const {
    PackedShape data{};
    const Direction n = normal();
    double longest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Point &a = corners[i], &b = corners[(i + 1) % 4];
      const Direction inward = glm::normalize(glm::cross(n, b - a));
      data[2 + i] = {inward, glm::dot(inward, a - origin)};
      longest = std::max(longest, glm::length(b - a));
    }
    data[0] = {corners[0] - origin, 0};
    data[1] = {n, longest};
    return data;
  }

  ShapeWords words(LengthText text) const {
    const auto side = [&](std::size_t i) { return text(glm::length(corners[(i + 1) % 4] - corners[i])); };
    const double lean = degrees(std::asin(std::min(1.0, std::abs(normal().z))));
    ShapeWords words{trFormat("Flat, {} x {} mm. ", side(0), side(1)), {}};
    words.stance = lean < 0.05 ? tr("Upright on the blue line, its reflecting side towards the eye")
                               : trFormat("Over the blue outline, leaning {:.1f} degrees from upright", lean);
    return words;
  }
};

}  // namespace anamorph
