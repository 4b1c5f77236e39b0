#include "math/frame.h"

#include <glm/common.hpp>

namespace anamorph {

Direction perpendicular(const Direction& d) {
  // Crossing with the axis that d leans on least keeps the length well away from 0.
  const Vector a = glm::abs(d);
  const Direction axis = a.x <= a.y && a.x <= a.z ? Direction(1, 0, 0)
                         : a.y <= a.z             ? Direction(0, 1, 0)
                                                  : Direction(0, 0, 1);
  return glm::normalize(glm::cross(d, axis));
}

Frame makeFrame(const Direction& forward, const Direction& up) {
  Vector side = glm::cross(forward, up);
  side -= glm::dot(side, forward) * forward;  // rounding, which counts when up leans little
  const double sine = glm::length(side);
  const Direction right = sine > 1e-9 ? side / sine : perpendicular(forward);
  return {right, glm::cross(right, forward), forward};
}

}  // namespace anamorph
