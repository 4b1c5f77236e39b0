#include "geometry/corner_grid.h"

#include <limits>

namespace anamorph {

CornerGrid::CornerGrid(const std::vector<Point2>& points, const std::vector<std::size_t>& numbers) {
  if (numbers.empty()) return;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Point2 low{infinity}, high{-infinity};
  for (const std::size_t number : numbers) {
    low = glm::min(low, points[number]);
    high = glm::max(high, points[number]);
  }
  side_ = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(numbers.size()))));
  origin_ = low;
  for (int axis = 0; axis < 2; ++axis) {
    const double scale = static_cast<double>(side_) / (high[axis] - low[axis]);
    scale_[axis] = std::isfinite(scale) ? scale : 0;  // all in the first cell
  }
  cells_.resize(side_ * side_);
  for (const std::size_t number : numbers)
    cells_[rowOf(points[number].y) * side_ + columnOf(points[number].x)].push_back(number);
}

void CornerGrid::remove(std::size_t number, const Point2& point) {
  if (!cells_.empty()) std::erase(cells_[rowOf(point.y) * side_ + columnOf(point.x)], number);
}

std::size_t CornerGrid::stepOf(double offset, double scale) const {
  const double step = std::floor(offset * scale);
  return static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(side_ - 1)));
}

// The triangle between the row's lower and upper border, and a cell to each side for what rounding has taken.
CornerGrid::Columns CornerGrid::columnsIn(const std::array<Point2, 3>& triangle, std::size_t row) const {
  const bool isFlat = scale_.y == 0;
  const double low = isFlat ? -std::numeric_limits<double>::infinity()
                            : origin_.y + (static_cast<double>(row) - 0.01) / scale_.y;
  const double high = isFlat ? std::numeric_limits<double>::infinity()
                             : origin_.y + (static_cast<double>(row) + 1.01) / scale_.y;
  double left = std::numeric_limits<double>::infinity(), right = -left;
  const auto take = [&](double x) {
    left = std::min(left, x);
    right = std::max(right, x);
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 a = triangle[i], b = triangle[(i + 1) % 3];
    if (a.y >= low && a.y <= high) take(a.x);
    for (const double border : {low, high}) {
      const double t = (border - a.y) / (b.y - a.y);
      if (t > 0 && t < 1) take(a.x + t * (b.x - a.x));
    }
  }
  if (!(left <= right)) return {0, side_};  // the triangle is thinner than rounding: look at all
  const std::size_t first = columnOf(left), last = columnOf(right);
  return {first - (first > 0 ? 1 : 0), std::min(last + 2, side_)};
}

}  // namespace anamorph
