// The law of reflection.
#pragma once

#include "math/vec.h"

namespace anamorph {

/// R = D - 2 (D . N) N, the direction after the mirror; which side N points to does not matter (method
/// section 2).
inline Direction reflect(const Direction& d, const Direction& normal) {
  return d - 2 * glm::dot(d, normal) * normal;
}

}  // namespace anamorph
