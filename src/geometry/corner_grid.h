// Corners of a flat polygon by their place, for ear clipping: which of them lie in a triangle? About as many cells as
// corners, so that a triangle that is small or thin looks at few of them, of however many a polygon has.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

namespace anamorph {

using Point2 = glm::dvec2;

class CornerGrid {
 public:
  CornerGrid() = default;

  /// Of the points those with these numbers.
  CornerGrid(const std::vector<Point2>& points, const std::vector<std::size_t>& numbers);

  /// Takes a corner out; nothing happens when it is not in.
  void remove(std::size_t number, const Point2& point);

  /// Whether `isIn(number)` is false for all corners in the cells that the triangle touches.
  template <typename IsIn>
  bool noneIn(const std::array<Point2, 3>& triangle, const IsIn& isIn) const {
    if (cells_.empty()) return true;
    double low = triangle[0].y, high = low;
    for (const Point2& p : triangle) low = std::min(low, p.y), high = std::max(high, p.y);
    for (std::size_t row = rowOf(low), last = rowOf(high); row <= last; ++row) {
      const auto [first, end] = columnsIn(triangle, row);
      for (std::size_t column = first; column < end; ++column) {
        for (const std::size_t number : cells_[row * side_ + column]) {
          if (isIn(number)) return false;
        }
      }
    }
    return true;
  }

 private:
  struct Columns {
    std::size_t first, end;
  };

  std::size_t stepOf(double offset, double scale) const;
  std::size_t columnOf(double x) const { return stepOf(x - origin_.x, scale_.x); }
  std::size_t rowOf(double y) const { return stepOf(y - origin_.y, scale_.y); }
  Columns columnsIn(const std::array<Point2, 3>& triangle, std::size_t row) const;

  std::size_t side_ = 0;  // cells along each axis
  Point2 origin_{0}, scale_{0};
  std::vector<std::vector<std::size_t>> cells_;  // row by row
};

}  // namespace anamorph
