// The canvas of a level without a mirror: nothing reflects there, so it is drawn as thin lines along its
// surface.
//
//     +--+--+--+--+
//     |  |  |  |  |        at even steps of the shape's own parameters (SurfaceLines of optics/shape.h)
//     +--+--+--+--+
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
