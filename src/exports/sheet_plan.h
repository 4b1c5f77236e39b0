// The middle of the viewing sheet: mirror, sculpture and eye seen from above, with their distances.
//
//          |<-- mirror -->|            A strip of the page above and below belongs to the widths, one to
//             .-----.     _            the right to the distances from the middle of the mirror; the lowest
//            |   +   | - - - - - -     is the eye's: its place, or an arrow where the page is too short for
//             '-----'      |   |       it.
//           .--. | .--.  __|   |
//           '---------'  ______|       The cross is below the mirror's middle.
//       |<----->|<----->|
//               x eye
#pragma once

#include "exports/arrangement.h"
#include "exports/page_drawing.h"
#include "exports/silhouette.h"

namespace anamorph {

struct Rectangle {
  Point2 min{0}, max{0};
  Point2 size() const { return max - min; }
};

/// What is drawn, in millimetres of the plan (right, away).
struct SheetPlan {
  bool hasMirror = true;               ///< else the mirror is a canvas
  std::vector<Loop> mirror;            ///< its outline; one of two points when it is flat and stands upright
  std::optional<double> mirrorRadius;  ///< of one that is a circle around the origin
  std::vector<Loop> sculpture;
  Loop plate;
  std::vector<Point2> posts;
  double postRadius = 0;
  Point2 eye{0};
  double eyeHeight = 0;                       ///< above the table
  Rectangle mirrorBox, sculptureBox, things;  ///< things: mirror, sculpture and plate
  Point2 x{1, 0}, y{0, 1};                    ///< directions of the mesh files' axes
};

SheetPlan makeSheetPlan(const Arrangement& arrangement);

/// How much of the page it takes at 1 : `scale`, with or without the eye's place.
Point2 sizeOnPage(const SheetPlan& plan, double scale, bool withEye);

/// Draws it at 1 : `scale` into the middle of the area.
void drawSheetPlan(Page& page, const SheetPlan& plan, const Rectangle& area, double scale, bool withEye);

}  // namespace anamorph
