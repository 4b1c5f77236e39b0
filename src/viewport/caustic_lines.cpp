#include "viewport/caustic_lines.h"

#include "math/palette.h"

namespace anamorph {

std::vector<Line> makeCausticLines(const std::vector<CausticPoint>& points) {
  constexpr double dot = 4;  // pixels at 100 %
  std::vector<Line> lines;
  for (const CausticPoint& point : points) {
    Line line{point.at, point.at, inkOf(point.second ? palette::secondCaustic : palette::firstCaustic)};
    line.width = dot;
    lines.push_back(line);
  }
  return lines;
}

}  // namespace anamorph
