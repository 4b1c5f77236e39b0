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
  void extend(const Box& other) {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  /// Which of the eight: bits 1, 2 and 4 of `number` take the larger x, y and z.
  Point corner(int number) const {
    return {number & 1 ? max.x : min.x, number & 2 ? max.y : min.y, number & 4 ? max.z : min.z};
  }
  /// Undefined for an empty box, as are size() and diagonal().
  Point centre() const { return 0.5 * (min + max); }
  Vector size() const { return max - min; }
  double diagonal() const { return glm::length(size()); }
};

}  // namespace anamorph
