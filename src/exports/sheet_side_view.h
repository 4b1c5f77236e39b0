// The small picture of the viewing sheet: eye, mirror and sculpture from the side, with their heights.
//
//     eye ---.__       _____ ............ mirror  100.0
//      |         '--> |     |
//      |    ____.-----|     | ........... sculpture, top  38.4
//      |   |__/       |     | ........... bottom  25.1
//     =======================  table
#pragma once

#include <optional>
#include <vector>

#include "exports/sheet_plan.h"

namespace anamorph {

struct HeightLabel {
  Point2 at{0};  ///< where in the side view the line to it begins
  std::string text;
};

/// In millimetres of (away from the viewer, height above the table).
struct SideView {
  Loop mirror;  ///< its hull; two points when it is seen edge-on
  std::vector<Loop> sculpture;
  std::vector<Loop> plate;  ///< with its posts
  Point2 eye{0};
  std::optional<std::vector<Point2>> ray;  ///< one from the eye by the mirror to the sculpture
  std::vector<HeightLabel> labels;         ///< upper ones first
  Rectangle box;
};

SideView makeSideView(const LevelResult& finished, const Arrangement& arrangement);

/// Draws it into the area, as large as fits, and says how large that is.
void drawSideView(Page& page, const SideView& view, const Rectangle& area);

}  // namespace anamorph
