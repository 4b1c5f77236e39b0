// Axis-aligned box. The default box is empty: it contains nothing, and extending it by a point gives that point.
#pragma once

#include <glm/common.hpp>

#include <limits>

#include "math/vec.h"

namespace anamorph {

struct Box {
  Point min{std::numeric_limits<double>::infinity()};
  Point max{-std::numeric_limits<double>::infinity()};

  bool operator==(const Box&) const = default;
  bool empty() const { return min.x > max.x; }
  void extend(const Point& p) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  /// Undefined for an empty box, as are size() and diagonal().
  Point centre() const { return 0.5 * (min + max); }
  Vector size() const { return max - min; }
  double diagonal() const { return glm::length(size()); }
};

}  // namespace anamorph
