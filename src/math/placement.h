// Where an object stands: scaled first, then rotated about x, y and z (in this order, about the fixed axes), then moved.
#pragma once

#include <glm/mat3x3.hpp>

#include "math/vec.h"

namespace anamorph {

struct Placement {
  Point position{0};
  Vector rotationDegrees{0};
  Vector scale{1};

  bool operator==(const Placement&) const = default;
};

/// Rz * Ry * Rx, angles in degrees.
glm::dmat3 rotationMatrix(const Vector& rotationDegrees);

/// Angles with rotationMatrix(angles) = `rotation`, of all such the ones nearest to `near`. With y at +-90
/// degrees x and z turn about the same axis; z then keeps its angle. Rounded to 1e-9 degrees, so that files
/// stay readable.
Vector eulerDegrees(const glm::dmat3& rotation, const Vector& near);

/// position + R * (scale * p). With no rotation and scale 1 the result is exactly position + p.
class PlacementMap {
 public:
  explicit PlacementMap(const Placement& placement);
  Point operator()(const Point& p) const;

 private:
  Point position_;
  glm::dmat3 linear_;
  bool onlyMoves_;
};

}  // namespace anamorph
