// A ray origin + t * direction, t >= 0. Where nothing else is said the direction has length 1; intersection functions
// take any length > 0 and count t in it, so a ray sent from E with direction P - E reaches P at t = 1.
#pragma once

#include "math/vec.h"

namespace anamorph {

struct Ray {
  Point origin{0};
  Vector direction{0, 0, 1};

  Point at(double t) const { return origin + t * direction; }
};

}  // namespace anamorph
