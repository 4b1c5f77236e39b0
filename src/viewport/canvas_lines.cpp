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

}  // namespace

std::vector<Line> makeCanvasLines(const Optic& optic, bool selected) {
  std::vector<Line> lines;
  if (isVisible(optic) || findShapeProblem(optic.shape())) return lines;
  const Shape& shape = optic.shape();
  const SurfaceLines grid = shape->lines();
  const Color color = inkOf(selected ? palette::selected : palette::canvas);
  for (int i = 0; i < grid.stepsU + !grid.closedU; ++i) {
    const double u = double(i) / grid.stepsU;
    addLine(lines, grid.chordsV, color, isStrong(grid.strongU, u),
            [&](double v) { return pointAt(shape, u, v); });
  }
  for (int j = 0; j <= grid.stepsV; ++j) {
    const double v = double(j) / grid.stepsV;
    addLine(lines, grid.chordsU, color, isStrong(grid.strongV, v),
            [&](double u) { return pointAt(shape, u, v); });
  }
  return lines;
}

}  // namespace anamorph
