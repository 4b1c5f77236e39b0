// Straight lines in space, as the 3D view draws them: rays, the RT camera's frustum, the construction of a
// vertex. Plain data, made by pure functions and drawn by line_pass.h.
#pragma once

#include "math/vec.h"
#include "raytrace/ray_looks.h"

namespace anamorph {

struct Line {
  Point from{0};
  Point to{0};
  Color color{1};  ///< as displayed (sRGB), not linear light: lines are ink, not surfaces
  double alpha = 1;
  double width = 2;  ///< pixels at 100 % UI scale
  LineStyle style = LineStyle::solid;
  bool arrow = false;  ///< an arrow head in the middle, pointing from `from` to `to`
  bool inFront =
      false;  ///< drawn at full strength even where something is before it; others shine through faintly

  bool operator==(const Line&) const = default;
};

/// A line that looks so, between the same points.
inline Line makeLine(const LineLook& look) {
  Line line;
  line.color = inkOf(look.color);
  line.alpha = look.alpha;
  line.style = look.style;
  line.arrow = look.arrow;
  return line;
}

}  // namespace anamorph
