// The canvas of a level without a mirror: nothing reflects there, so it is drawn as thin lines along its
// surface.
//
//     +--+--+--+--+
//     |  |  |  |  |        a plane: a grid between its corners; a cylinder: rings and lines along it;
//     +--+--+--+--+        a sphere: meridians and parallels about the vertical
//     |  |  |  |  |
//     +--+--+--+--+
#pragma once

#include <vector>

#include "optics/optic.h"
#include "viewport/line.h"

namespace anamorph {

/// Empty for a mirror, and for a shape with a problem (findShapeProblem). Selected ones are orange.
std::vector<Line> makeCanvasLines(const Optic& optic, bool selected);

}  // namespace anamorph
