#include "optics/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "base/language.h"

namespace anamorph {
namespace {

using Cell = PatchMirror::Cell;
using Prepared = PatchMirror::Prepared;

std::array<Cubic, 4> transposed(const std::array<Cubic, 4>& g) {
  std::array<Cubic, 4> t;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) t[j].c[i] = g[i].c[j];
  }
  return t;
}

// Control heights of a spline to those of its one cell: along the rows, then along the columns.
Cell cellOf(const HeightGrid& heights, std::size_t column, std::size_t row) {
  Cell cell;
  for (std::size_t j = 0; j < 4; ++j) {
    const auto h = [&](std::size_t i) { return heights.at(row + j, column + i); };
    cell.rows[j] = splineSpan(h(0), h(1), h(2), h(3));
  }
  cell.rows = transposed(cell.rows);
  for (Cubic& c : cell.rows) c = splineSpan(c.c[0], c.c[1], c.c[2], c.c[3]);
  cell.rows = transposed(cell.rows);
  cell.least = cell.greatest = cell.rows[0].c[0];
  for (const Cubic& row_ : cell.rows) {
    const auto [low, high] = std::minmax_element(row_.c.begin(), row_.c.end());
    cell.least = std::min(cell.least, *low);
    cell.greatest = std::max(cell.greatest, *high);
  }
  return cell;
}

// The heights below a piece of a ray, from one place in the cell to another.
Bernstein<6> heightsAlong(const Cell& cell, const CurvePoint& from, const CurvePoint& to) {
  std::array<Cubic, 4> g = cell.rows;
  for (Cubic& row : g) row = partOf(row, from.x, to.x);
  g = transposed(g);
  for (Cubic& column : g) column = partOf(column, from.y, to.y);
  return alongDiagonal(g);
}

// The least value of a piecewise bicubic: never less than control values, which lie below it, never more than corners,
// which lie on it. What may hold less than the least corner is split.
class LeastValue {
 public:
  explicit LeastValue(double tolerance) : tolerance_(tolerance) {}

  void addCorners(const std::array<Cubic, 4>& g) {
    reached_ = std::min({reached_, g[0].c[0], g[0].c[3], g[3].c[0], g[3].c[3]});
  }
  void add(const std::array<Cubic, 4>& g) {
    double low = g[0].c[0];
    for (const Cubic& row : g) low = std::min(low, *std::min_element(row.c.begin(), row.c.end()));
    if (!(low < reached_ - tolerance_)) {
      bound_ = std::min(bound_, low);
      return;
    }
    const auto [left, right] = halves(g);
    for (const auto& half : {left, right}) {
      const auto [below, above] = halves(transposed(half));
      addCorners(below);
      addCorners(above);
      add(below);
      add(above);
    }
  }
  double value() const { return std::min(reached_, bound_); }

 private:
  static std::pair<std::array<Cubic, 4>, std::array<Cubic, 4>> halves(const std::array<Cubic, 4>& g) {
    std::pair<std::array<Cubic, 4>, std::array<Cubic, 4>> two;
    for (std::size_t j = 0; j < 4; ++j) std::tie(two.first[j], two.second[j]) = split(g[j], 0.5);
    return two;
  }

  double tolerance_;
  double reached_ = std::numeric_limits<double>::infinity(), bound_ = reached_;
};

// Along one axis: which cell the ray is in, and where it comes to the next.
struct Walk {
  double at, direction, cellSize;
  int count, index;

  Walk(double from, double along, double size, int cells, double start)
      : at(from),
        direction(along),
        cellSize(size),
        count(cells),
        index(std::clamp(static_cast<int>(std::floor((from + start * along) / size)), 0, cells - 1)) {}

  int step() const { return direction < 0 ? -1 : 1; }
  double next() const {
    const bool last = direction == 0 || index == (direction < 0 ? 0 : count - 1);
    const int knot = direction < 0 ? index : index + 1;
    return last ? std::numeric_limits<double>::infinity() : (knot * cellSize - at) / direction;
  }
  double inCell(double place) const { return place / cellSize - index; }
};

}  // namespace

Axes PatchMirror::frame() const {
  const Direction x = glm::normalize(across), y = glm::normalize(up - glm::dot(up, x) * x);
  return {x, y, glm::cross(x, y)};
}

std::array<int, 2> PatchMirror::cellCount() const {
  const auto spans = [](std::size_t controls) { return std::max(0, static_cast<int>(controls) - 3); };
  return {spans(heights.columns), spans(heights.rows())};
}

PatchMirror::Place PatchMirror::placeAt(double x, double y) const {
  const auto [columns, rows] = cellCount();
  const double u = x / size[0] * columns, v = y / size[1] * rows;
  const double column = std::clamp(std::floor(u), 0.0, columns - 1.0);
  const double row = std::clamp(std::floor(v), 0.0, rows - 1.0);
  const Cell cell = cellOf(heights, static_cast<std::size_t>(column), static_cast<std::size_t>(row));
  return placeIn(cell, u - column, v - row);
}

PatchMirror::Place PatchMirror::placeIn(const Cell& cell, double u, double v) const {
  const auto [columns, rows] = cellCount();
  Cubic value, slope;
  for (std::size_t j = 0; j < 4; ++j) {
    const ValueAndSlope along = valueAndSlope(cell.rows[j], u);
    value.c[j] = along.value;
    slope.c[j] = along.slope;
  }
  const ValueAndSlope here = valueAndSlope(value, v);
  return {here.value, valueAndSlope(slope, v).value * columns / size[0], here.slope * rows / size[1]};
}

PatchMirror::Prepared PatchMirror::prepare() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Prepared prepared{frame(), size, cellCount(), {}, infinity, -infinity};
  for (int row = 0; row < prepared.count[1]; ++row) {
    for (int column = 0; column < prepared.count[0]; ++column) {
      prepared.cells.push_back(
          cellOf(heights, static_cast<std::size_t>(column), static_cast<std::size_t>(row)));
      prepared.least = std::min(prepared.least, prepared.cells.back().least);
      prepared.greatest = std::max(prepared.greatest, prepared.cells.back().greatest);
    }
  }
  return prepared;
}

std::optional<SurfaceHit> PatchMirror::firstHit(const Prepared& prepared, const Ray& ray, double tMin,
                                                const Stretch& within) const {
  if (prepared.cells.empty()) return std::nullopt;
  const FrameRay local = rayInFrame(ray, origin, prepared.axes);
  const double extent = std::max(size[0], size[1]), slack = 1e-9 * extent;
  Stretch stretch = within.countedFrom(local.start);
  stretch.keepBetween(local.at.x, local.direction.x, 0, size[0]);
  stretch.keepBetween(local.at.y, local.direction.y, 0, size[1]);
  stretch.keepBetween(local.at.z, local.direction.z, prepared.least - slack, prepared.greatest + slack);
  const double nearest = tMin - local.start;
  const double overlap = pieceOverlap * extent / glm::length(local.direction);
  if (stretch.empty() || stretch.to + overlap <= nearest) return std::nullopt;

  const auto [width, height] = prepared.cellSize();
  Walk x(local.at.x, local.direction.x, width, prepared.count[0], stretch.from);
  Walk y(local.at.y, local.direction.y, height, prepared.count[1], stretch.from);
  CrossingFilter filter(4 * overlap);
  double from = stretch.from;
  while (true) {
    const double to = std::max(from, std::min({stretch.to, x.next(), y.next()}));
    const double start = from - overlap, length = to + overlap - start;
    const Point a = local.after(start), b = local.after(to + overlap);
    const Cell& cell = prepared.cell(x.index, y.index);
    const bool passes = to + overlap > nearest && std::max(a.z, b.z) >= cell.least - slack &&
                        std::min(a.z, b.z) <= cell.greatest + slack;
    if (passes) {
      Bernstein<6> above = heightsAlong(cell, {x.inCell(a.x), y.inCell(a.y)}, {x.inCell(b.x), y.inCell(b.y)});
      for (int k = 0; k <= 6; ++k) {
        double& c = above.c[static_cast<std::size_t>(k)];
        c = a.z + (b.z - a.z) * (k * (1.0 / 6)) - c;
      }
      for (const Crossing& crossing : findCrossings(above, (nearest - start) / length)) {
        const double way = start + crossing.at * length, t = local.start + way;
        if (!filter.isNew(way, crossing.rising) || !(t > tMin)) continue;
        const Point p = local.after(way);
        const auto [z, slopeX, slopeY] = placeIn(cell, x.inCell(p.x), y.inCell(p.y));
        return hitAt(ray, t, prepared.axes, {-slopeX, -slopeY, 1});
      }
    }
    if (to >= stretch.to) return std::nullopt;
    Walk& next = x.next() <= y.next() ? x : y;
    next.index += next.step();
    from = to;
  }
}

Box PatchMirror::box() const {
  constexpr double exactness = 1e-5;
  const Prepared prepared = prepare();
  const double width = prepared.cellSize()[0], height = prepared.cellSize()[1];
  Box box;
  for (int k = 0; k < 3; ++k) {
    std::array<LeastValue, 2> ends{LeastValue(exactness * std::max(size[0], size[1])),
                                   LeastValue(exactness * std::max(size[0], size[1]))};
    const auto forEachCell = [&](const auto& visit) {
      for (int row = 0; row < prepared.count[1]; ++row) {
        for (int column = 0; column < prepared.count[0]; ++column) {
          std::array<Cubic, 4> g = prepared.cell(column, row).rows, negative;
          for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t i = 0; i < 4; ++i) {
              g[j].c[i] = origin[k] + (column + i / 3.0) * width * prepared.axes[0][k] +
                          (row + j / 3.0) * height * prepared.axes[1][k] + g[j].c[i] * prepared.axes[2][k];
              negative[j].c[i] = -g[j].c[i];
            }
          }
          visit(ends[0], g);
          visit(ends[1], negative);
        }
      }
    };
    forEachCell([](LeastValue& least, const auto& g) { least.addCorners(g); });
    forEachCell([](LeastValue& least, const auto& g) { least.add(g); });
    box.min[k] = ends[0].value();
    box.max[k] = -ends[1].value();
  }
  return box;
}

std::optional<std::string> PatchMirror::findProblem() const {
  if (heights.columns < fewestOpenControls || heights.rows() < fewestOpenControls) {
    return trFormat("expected at least {0} rows of at least {0} heights, got {1} rows of {2}",
                    fewestOpenControls, heights.rows(), heights.columns);
  }
  if (auto problem = findLengthProblem("width", size[0])) return problem;
  if (auto problem = findLengthProblem("height", size[1])) return problem;
  if (!(glm::length(across) > 0)) return tr("expected a direction across that is not 0");
  const double sine = glm::length(glm::cross(glm::normalize(across), glm::normalize(up)));
  if (!(sine > shapeTolerance)) return tr("expected a direction up that is not along the one across");
  return std::nullopt;
}

std::optional<std::string> PatchMirror::findEyeProblem(const Prepared& prepared, const Point& eye) const {
  const Vector at = inFrame(prepared.axes, eye - origin);
  const double extent = std::max(size[0], size[1]), tolerance = shapeTolerance * extent;
  if (auto problem = findDistanceProblem(glm::length(eye - middle()), extent, "size")) return problem;
  const double x = std::clamp(at.x, 0.0, size[0]), y = std::clamp(at.y, 0.0, size[1]);
  if (std::hypot(at.x - x, at.y - y) > tolerance) return std::nullopt;
  const auto [height, slopeX, slopeY] = placeAt(x, y);
  if (std::abs(at.z - height) > tolerance * std::sqrt(1 + slopeX * slopeX + slopeY * slopeY)) {
    return std::nullopt;
  }
  return findContactProblem(0, 1);
}

Point PatchMirror::eyeOutside(const Point&, const Point& original) const {
  const Direction normal = frame()[2];
  const double away = std::max(size[0], size[1]);
  return middle() + away * (glm::dot(normal, original - middle()) > 0 ? -normal : normal);
}

Axes PatchMirror::axes() const {
  const Axes f = frame();
  return {f[0], -f[2], f[1]};
}

ShapeExtent PatchMirror::extent() const {
  return {middle(), frame()[1], size[0], size[1]};
}

PatchMirror PatchMirror::filling(const ShapeExtent& e, const Point& eye) {
  const Vector towards = eye - e.middle, flat = towards - glm::dot(towards, e.up) * e.up;
  const Direction n = glm::length(flat) > 1e-9 ? glm::normalize(flat) : perpendicular(e.up);
  PatchMirror made;
  made.across = glm::cross(e.up, n);
  made.up = e.up;
  const double factor = 0.5 * std::min(e.width / made.size[0], e.height / made.size[1]);
  made.size = {e.width, e.height};
  for (double& h : made.heights.heights) h *= factor;
  made.origin = e.middle;
  made.origin += e.middle - made.middle();
  return made;
}

// A control value stands over a knot, the outermost ones a cell beyond the border.
std::vector<ControlPoint> PatchMirror::controlPoints() const {
  const Axes f = frame();
  const auto [columns, rows] = cellCount();
  std::vector<ControlPoint> points;
  for (std::size_t row = 0; row < heights.rows(); ++row) {
    for (std::size_t column = 0; column < heights.columns; ++column) {
      const double x = (static_cast<double>(column) - 1) * size[0] / columns;
      const double y = (static_cast<double>(row) - 1) * size[1] / rows;
      points.push_back(
          {origin + x * f[0] + y * f[1] + heights.at(row, column) * f[2], {f[2], f[0], f[1]}, 1});
    }
  }
  return points;
}

void PatchMirror::moveControlPoint(std::size_t number, const Vector& motion) {
  if (number < heights.heights.size()) heights.heights[number] += glm::dot(motion, frame()[2]);
}

void PatchMirror::map(const ShapeMap& map) {
  const Point old = origin;
  across = turnedBy(map, old, across);
  up = turnedBy(map, old, up);
  origin = map.point(old);
  size = {map.size(size[0], map.factors.x), map.size(size[1], map.factors.z)};
  for (double& h : heights.heights) h = std::clamp(h * map.factors.y, -map.maxSize, map.maxSize);
}

void PatchMirror::carryOn() {
  const auto [columns, rows] = cellCount();
  if (columns == 0 || rows == 0) return;
  const auto inside = [](int i, int more, std::size_t count) {
    return static_cast<std::size_t>(std::clamp(i - more, 0, static_cast<int>(count) - 1));
  };
  HeightGrid wider{heights.columns + 2 * static_cast<std::size_t>(columns), {}};
  for (int row = 0; row < 3 * rows + 3; ++row) {
    for (int column = 0; column < 3 * columns + 3; ++column) {
      wider.heights.push_back(
          heights.at(inside(row, rows, heights.rows()), inside(column, columns, heights.columns)));
    }
  }
  const Axes f = frame();
  origin -= size[0] * f[0] + size[1] * f[1];
  size = {3 * size[0], 3 * size[1]};
  heights = std::move(wider);
}

Point PatchMirror::pointAt(double u, double v) const {
  const double x = u * size[0], y = v * size[1];
  return origin + fromFrame(frame(), {x, y, placeAt(x, y).height});
}

Direction PatchMirror::normalAt(double u, double v) const {
  const auto [height, slopeX, slopeY] = placeAt(u * size[0], v * size[1]);
  return fromFrame(frame(), glm::normalize(Vector(-slopeX, -slopeY, 1)));
}

// Lines end at knots.
std::array<int, 2> PatchMirror::gridFor(int segments) const {
  const auto lines = [&](int cells) { return cells * std::max(2, segments / std::max(1, cells)); };
  const auto [columns, rows] = cellCount();
  return {lines(columns), lines(rows)};
}

SurfaceLines PatchMirror::lines() const {
  const auto [columns, rows] = cellCount();
  return {8, 8, false, std::clamp(6 * columns, 8, 120), std::clamp(6 * rows, 8, 120), {0, 1}, {0, 1}};
}

double PatchMirror::borderDistance(const Point& p) const {
  const Vector at = inFrame(frame(), p - origin);
  return std::min({at.x, size[0] - at.x, at.y, size[1] - at.y}) / std::max(size[0], size[1]);
}

ShapeWords PatchMirror::words(LengthText text) const {
  constexpr int steps = 4;
  std::string table;
  for (int row = 0; row <= steps; ++row) {
    for (int column = 0; column <= steps; ++column) {
      const double x = size[0] * column / steps, y = size[1] * row / steps;
      table += (column > 0 ? ", " : row > 0 ? "; " : "") + text(placeAt(x, y).height);
    }
  }
  const double lean = degrees(std::asin(std::min(1.0, std::abs(frame()[2].z))));
  return {trFormat("A curved patch, {} x {} mm. Its heights over its plane at every quarter, from the lowest "
                   "row on, in mm: {}. ",
                   text(size[0]), text(size[1]), table),
          lean < 0.05 ? tr("Upright on the blue outline")
                      : trFormat("Over the blue outline, leaning {:.1f} degrees from upright", lean)};
}

}  // namespace anamorph
