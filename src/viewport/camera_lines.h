// The RT camera's frustum and its pixel grid as lines.
//
//          +--+--+--+          the grid is `distance` in front of the eye, as high as the field of view
//     E <  |  |  |  |          is wide there, with square cells
//          +--+--+--+
#pragma once

#include <optional>
#include <vector>

#include "edit/pick.h"
#include "optics/camera.h"
#include "viewport/line.h"

namespace anamorph {

/// Empty when the view's eye is the RT camera's own: the grid would be between it and everything else.
std::vector<Line> makeCameraLines(const Camera& camera, const PixelGrid& grid, bool selected,
                                  const std::optional<GridCell>& cell, const Point& viewEye);

}  // namespace anamorph
