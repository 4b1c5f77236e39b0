#include "viewport/camera_lines.h"

#include <cmath>

#include "math/palette.h"
#include "optics/camera.h"

namespace anamorph {
namespace {

// Image positions of the grid, in cells, to points of the screen.
class Screen {
 public:
  Screen(const Camera& camera, const PixelGrid& grid)
      : projection_(camera, grid.columns, grid.rows), distance_(grid.distance) {}

  Point at(double column, double row) const {
    const Ray ray = projection_.rayThrough({column, row});
    return ray.at(distance_ / glm::dot(ray.direction, projection_.frame().forward));
  }

 private:
  Projection projection_;
  double distance_;
};

}  // namespace

std::vector<Line> makeCameraLines(const Camera& camera, const PixelGrid& grid, bool selected,
                                  const std::optional<GridCell>& cell, const Point& viewEye) {
  std::vector<Line> lines;
  if (glm::length(viewEye - camera.eye) < 0.5 * grid.distance) return lines;
  const Screen screen(camera, grid);
  const int columns = grid.columns, rows = grid.rows;
  const auto add = [&](const Point& from, const Point& to, const Color& color, double width, double alpha) {
    Line line;
    line.from = from;
    line.to = to;
    line.color = color;
    line.width = width;
    line.alpha = alpha;
    lines.push_back(line);
  };
  const Color color = inkOf(selected ? palette::selected : palette::rtCamera);
  for (int i = 0; i <= columns; ++i) {
    const bool edge = i == 0 || i == columns;
    add(screen.at(i, 0), screen.at(i, rows), color, edge ? 1.6 : 0.8, edge ? 1 : 0.55);
  }
  for (int j = 0; j <= rows; ++j) {
    const bool edge = j == 0 || j == rows;
    add(screen.at(0, j), screen.at(columns, j), color, edge ? 1.6 : 0.8, edge ? 1 : 0.55);
  }
  for (const auto& [i, j] : {std::pair{0, 0}, {columns, 0}, {columns, rows}, {0, rows}}) {
    add(camera.eye, screen.at(i, j), color, 1.4, 1);
  }
  if (cell) {
    const double x = cell->column, y = cell->row;
    const Point corners[] = {screen.at(x, y), screen.at(x + 1, y), screen.at(x + 1, y + 1),
                             screen.at(x, y + 1)};
    for (int i = 0; i < 4; ++i) add(corners[i], corners[(i + 1) % 4], inkOf(palette::chosenCell), 2.5, 1);
  }
  return lines;
}

}  // namespace anamorph
