#include "exports/silhouette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace anamorph {
namespace {

using Point2 = glm::dvec2;

constexpr double straightCells = 0.75;  // how far a straightened outline may be off
constexpr double leastLoopCells = 6;    // smaller loops are dust of the grid

class Grid {
 public:
  Grid(std::span<const Point2> points, std::span<const Triangle> triangles, int resolution) {
    Point2 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Triangle& t : triangles) {
      for (const std::uint32_t corner : t) {
        low = glm::min(low, points[corner]);
        high = glm::max(high, points[corner]);
      }
    }
    const Point2 size = high - low;
    const double longer = std::max(size.x, size.y);
    cell_ = longer > 0 ? longer / resolution : 1;
    origin_ = low - 2.0 * cell_;  // a border that stays empty
    width_ = static_cast<int>(size.x / cell_) + 5;
    height_ = static_cast<int>(size.y / cell_) + 5;
    covered_.assign(static_cast<std::size_t>(width_) * height_, 0);
  }

  int width() const { return width_; }
  int height() const { return height_; }
  bool covered(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ && covered_[index(x, y)] != 0;
  }
  Point2 toGrid(const Point2& p) const { return (p - origin_) / cell_; }
  Point2 fromGrid(const Point2& p) const { return origin_ + cell_ * p; }

  /// Cells whose middle is inside, and those that an edge runs through, so that nothing is too thin to see.
  void fill(const std::array<Point2, 3>& corners) {
    for (int i = 0; i < 3; ++i) drawLine(corners[i], corners[(i + 1) % 3]);
    const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    for (int y = static_cast<int>(std::ceil(low - 0.5)); y + 0.5 <= high; ++y) fillRow(corners, y);
  }

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }

  void fillRow(const std::array<Point2, 3>& corners, int y) {
    const double at = y + 0.5;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (int i = 0; i < 3; ++i) {
      const Point2 &p = corners[i], &q = corners[(i + 1) % 3];
      if ((p.y < at) == (q.y < at)) continue;
      const double x = p.x + (at - p.y) / (q.y - p.y) * (q.x - p.x);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    for (int x = static_cast<int>(std::ceil(left - 0.5)); x + 0.5 <= right; ++x) covered_[index(x, y)] = 1;
  }

  void drawLine(const Point2& p, const Point2& q) {
    const double longer = std::max(std::abs(q.x - p.x), std::abs(q.y - p.y));
    const int steps = static_cast<int>(longer) + 1;
    for (int i = 0; i <= steps; ++i) {
      const Point2 at = glm::mix(p, q, double(i) / steps);
      covered_[index(static_cast<int>(at.x), static_cast<int>(at.y))] = 1;
    }
  }

  Point2 origin_{0};
  double cell_ = 1;
  int width_ = 0, height_ = 0;
  std::vector<char> covered_;
};

constexpr int dx[4] = {1, 0, -1, 0}, dy[4] = {0, 1, 0, -1};  // east, north, west, south

// The sides of covered cells towards empty ones, with the covered cell to the left: from every corner of the
// grid one bit for each direction that such a side leaves in.
class Border {
 public:
  explicit Border(const Grid& grid) : width_(grid.width() + 1), height_(grid.height() + 1) {
    leaving_.assign(static_cast<std::size_t>(width_) * height_, 0);
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        const bool northEast = grid.covered(x, y), northWest = grid.covered(x - 1, y);
        const bool southEast = grid.covered(x, y - 1), southWest = grid.covered(x - 1, y - 1);
        at(x, y) = static_cast<char>((northEast && !southEast) | (northWest && !northEast) << 1 |
                                     (southWest && !northWest) << 2 | (southEast && !southWest) << 3);
      }
    }
  }

  std::vector<Loop> walk() {
    std::vector<Loop> loops;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        while (at(x, y) != 0) loops.push_back(walkFrom(x, y));
      }
    }
    return loops;
  }

 private:
  char& at(int x, int y) { return leaving_[static_cast<std::size_t>(y) * width_ + x]; }

  // Through the middles of the sides; where two ways are open to the right, so that cells that meet in a
  // corner belong together.
  Loop walkFrom(int startX, int startY) {
    Loop loop;
    int x = startX, y = startY, direction = 0;
    while ((at(x, y) >> direction & 1) == 0) ++direction;
    while (true) {
      at(x, y) = static_cast<char>(at(x, y) & ~(1 << direction));
      loop.push_back({x + 0.5 * dx[direction], y + 0.5 * dy[direction]});
      x += dx[direction];
      y += dy[direction];
      if (at(x, y) == 0) return loop;
      int next = (direction + 3) % 4;
      while ((at(x, y) >> next & 1) == 0) next = (next + 1) % 4;
      direction = next;
    }
  }

  int width_, height_;
  std::vector<char> leaving_;
};

double distanceToChord(const Point2& p, const Point2& a, const Point2& b) {
  const Point2 way = b - a;
  const double length = glm::length(way);
  if (length == 0) return glm::length(p - a);
  return std::abs(way.x * (p.y - a.y) - way.y * (p.x - a.x)) / length;
}

// Douglas and Peucker 1973: keeps the point farthest from the chord, while it is too far, on both sides of
// it.
Loop straighten(const Loop& loop, double tolerance) {
  const std::size_t n = loop.size();
  std::size_t far = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (glm::length(loop[i] - loop[0]) > glm::length(loop[far] - loop[0])) far = i;
  }
  std::vector<char> kept(n, 0);
  kept[0] = kept[far] = 1;
  std::vector<std::pair<std::size_t, std::size_t>> parts{{0, far}, {far, n}};
  while (!parts.empty()) {
    const auto [begin, end] = parts.back();
    parts.pop_back();
    double most = tolerance;
    std::size_t worst = begin;
    for (std::size_t i = begin + 1; i < end; ++i) {
      const double distance = distanceToChord(loop[i], loop[begin], loop[end % n]);
      if (distance > most) {
        most = distance;
        worst = i;
      }
    }
    if (worst == begin) continue;
    kept[worst] = 1;
    parts.push_back({begin, worst});
    parts.push_back({worst, end});
  }
  Loop result;
  for (std::size_t i = 0; i < n; ++i) {
    if (kept[i]) result.push_back(loop[i]);
  }
  return result;
}

double areaOf(const Loop& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point2 &p = loop[i], &q = loop[(i + 1) % loop.size()];
    twice += p.x * q.y - p.y * q.x;
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

std::vector<Loop> makeSilhouette(std::span<const Point2> points, std::span<const Triangle> triangles,
                                 int resolution) {
  if (triangles.empty()) return {};
  Grid grid(points, triangles, resolution);
  for (const Triangle& t : triangles) {
    grid.fill({grid.toGrid(points[t[0]]), grid.toGrid(points[t[1]]), grid.toGrid(points[t[2]])});
  }
  std::vector<Loop> loops;
  for (const Loop& loop : Border(grid).walk()) {
    if (areaOf(loop) < leastLoopCells) continue;
    loops.push_back(straighten(loop, straightCells));
    for (Point2& p : loops.back()) p = grid.fromGrid(p);
  }
  return loops;
}

}  // namespace anamorph
