#include "viewport/canvas_lines.h"

#include <algorithm>
#include <cmath>

#include "math/palette.h"

namespace anamorph {
namespace {

bool isStrong(const std::vector<double>& strong, double parameter) {
  return std::any_of(strong.begin(), strong.end(), [&](double s) { return std::abs(s - parameter) < 1e-9; });
}

// The line of the surface whose points at(t) are, t from 0 to 1, as straight pieces.
template <typename At>
void addLine(std::vector<Line>& lines, int chords, const Color& color, bool strong, const At& at) {
  for (int i = 0; i < chords; ++i) {
    lines.push_back(
        {at(double(i) / chords), at(double(i + 1) / chords), color, strong ? 0.95 : 0.4, strong ? 1.8 : 0.9});
  }
}

// Of a surface without parameters some of its triangles.
void addTriangles(std::vector<Line>& lines, const Mesh& mesh, const Color& color) {
  constexpr std::size_t most = 1000;
  const std::size_t step = 1 + mesh.triangles.size() / most;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const Triangle& corners = mesh.triangles[t];
    addLine(lines, 3, color, false, [&](double side) {
      return mesh.positions[corners[static_cast<std::size_t>(3 * side + 0.5) % 3]];
    });
  }
}

bool isCutAway(const Line& line, const std::vector<HalfSpace>& clip) {
  const Point middle = 0.5 * (line.from + line.to);
  return !std::all_of(clip.begin(), clip.end(), [&](const HalfSpace& half) { return half.contains(middle); });
}

}  // namespace

std::vector<Line> makeCanvasLines(const Optic& optic, bool selected) {
  std::vector<Line> lines;
  if (isVisible(optic) || findShapeProblem(optic.shape())) return lines;
  const Shape& shape = optic.shape();
  const SurfaceLines grid = shape->lines();
  const Color color = inkOf(selected ? palette::selected : palette::canvas);
  if (grid.stepsU == 0) addTriangles(lines, tessellate(shape).mesh, color);
  for (int i = 0; grid.stepsU > 0 && i < grid.stepsU + !grid.closedU; ++i) {
    const double u = double(i) / grid.stepsU;
    addLine(lines, grid.chordsV, color, isStrong(grid.strongU, u),
            [&](double v) { return pointAt(shape, u, v); });
  }
  for (int j = 0; grid.stepsV > 0 && j <= grid.stepsV; ++j) {
    const double v = double(j) / grid.stepsV;
    addLine(lines, grid.chordsU, color, isStrong(grid.strongV, v),
            [&](double u) { return pointAt(shape, u, v); });
  }
  std::erase_if(lines, [&](const Line& line) { return isCutAway(line, shape.clip()); });
  return lines;
}

}  // namespace anamorph
