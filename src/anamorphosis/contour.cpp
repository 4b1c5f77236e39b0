#include "anamorphosis/contour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace anamorph {
namespace {

// Points by the cell of one unit that they are in.
class Cells {
 public:
  explicit Cells(const std::vector<Pixel>& points) {
    for (const Pixel& point : points) cells_[keyOf(cellOf(point.x), cellOf(point.y))].push_back(point);
  }

  // From `from` to the nearest point: cells in squares around its own, until none can be nearer.
  double nearest(const Pixel& from) const {
    const int x = cellOf(from.x), y = cellOf(from.y);
    double best = farthestContour;
    for (int ring = 0; ring <= static_cast<int>(farthestContour) && ring - 1 < best; ++ring) {
      for (int dy = -ring; dy <= ring; ++dy) {
        const int step = std::abs(dy) == ring ? 1 : std::max(2 * ring, 1);
        for (int dx = -ring; dx <= ring; dx += step) best = std::min(best, nearestIn(x + dx, y + dy, from));
      }
    }
    return best;
  }

 private:
  static int cellOf(double coordinate) { return static_cast<int>(std::floor(coordinate)); }
  static std::uint64_t keyOf(int x, int y) {
    return std::uint64_t{static_cast<std::uint32_t>(y)} << 32 | static_cast<std::uint32_t>(x);
  }

  double nearestIn(int x, int y, const Pixel& from) const {
    double best = farthestContour;
    const auto cell = cells_.find(keyOf(x, y));
    if (cell == cells_.end()) return best;
    for (const Pixel& point : cell->second) best = std::min(best, glm::length(point - from));
    return best;
  }

  std::unordered_map<std::uint64_t, std::vector<Pixel>> cells_;
};

}  // namespace

double contourDistance(const std::vector<Pixel>& a, const std::vector<Pixel>& b) {
  if (a.empty() && b.empty()) return 0;
  if (a.empty() || b.empty()) return farthestContour;
  const Cells cellsOfA(a), cellsOfB(b);
  std::vector<double> ways;
  ways.reserve(a.size() + b.size());
  for (const Pixel& point : a) ways.push_back(cellsOfB.nearest(point));
  for (const Pixel& point : b) ways.push_back(cellsOfA.nearest(point));
  const auto p99 = ways.begin() + static_cast<std::ptrdiff_t>((ways.size() - 1) * 99 / 100);
  std::nth_element(ways.begin(), p99, ways.end());
  return *p99;
}

}  // namespace anamorph
