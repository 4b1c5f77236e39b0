// One side of a plane: what it keeps are the points X with (X - point) . normal >= 0.
#pragma once

#include "math/vec.h"

namespace anamorph {

struct HalfSpace {
  Point point{0};
  Vector normal{0, 0, 1};  ///< of any length > 0

  bool operator==(const HalfSpace&) const = default;
  bool contains(const Point& x) const { return glm::dot(x - point, normal) >= 0; }
};

}  // namespace anamorph
