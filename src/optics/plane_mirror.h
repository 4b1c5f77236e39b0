// The arithmetic of one ray and the plane, shared by the single ray (mirror_shapes.h) and by many rays
// (exit_points.h), so that both give the same bits.
//
//            v3 ---------- v2         n . (E + t V - v0) = 0,   inside: to the left of all four edges
//             |     Q      |
//            v0 ---------- v1
#pragma once

#include "optics/mirror_shapes.h"

namespace anamorph {

struct PlaneForm {
  explicit PlaneForm(const PlaneMirror& plane) : corners(plane.corners), normal(planeNormal(plane)) {
    for (std::size_t i = 0; i < 4; ++i) {
      inward[i] = glm::cross(normal, corners[(i + 1) % 4] - corners[i]);
      border[i] = glm::dot(inward[i], corners[i]);
    }
  }

  /// From a point to the plane, along the normal. The ray E + t V is there at t = distanceFrom(E) / (normal .
  /// V).
  double distanceFrom(const Point& eye) const { return glm::dot(normal, corners[0] - eye); }
  bool contains(const Point& q) const {
    // & instead of && : no branches, so that loops over it vectorise.
    return (glm::dot(inward[0], q) >= border[0]) & (glm::dot(inward[1], q) >= border[1]) &
           (glm::dot(inward[2], q) >= border[2]) & (glm::dot(inward[3], q) >= border[3]);
  }

  std::array<Point, 4> corners;
  Direction normal;
  std::array<Vector, 4> inward;  // in the plane, perpendicular to each edge
  std::array<double, 4> border;  // inward . q on the edge itself
};

}  // namespace anamorph
