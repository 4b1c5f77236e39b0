// The viewing sheet: one page to set the mirror, the sculpture and the eye up by. Seen from above at 1 : 1
// where that fits the paper, so that mirror and sculpture are simply put on their outlines; a small side
// view with the heights; the steps in words; a ruler that shows whether the printer kept the size.
//
//     title, scale                   upright, or the same with the words beside the plan: whichever leaves
//     [      plan      ]             the plan more room
//     [ words ][ side  ]
//     |----- ruler ----|
#pragma once

#include <optional>
#include <string>

#include "exports/arrangement.h"
#include "exports/page.h"

namespace anamorph {

/// "A4", "A3", "letter".
const char* paperName(Paper paper);

struct ViewingSheet {
  Page page;
  double scale = 1;      ///< the plan is drawn at 1 : scale
  bool showsEye = true;  ///< else the eye's place is beyond the page, and an arrow points to it
};

/// At 1 : `scale`, or, without one, at 1 : 1 or the largest of 1 : 2, 1 : 5, 1 : 10, ... that fits. Throws
/// Error when the asked scale does not fit.
ViewingSheet makeViewingSheet(const LevelResult& finished, const Arrangement& arrangement, Paper paper,
                              std::optional<double> scale = {});

}  // namespace anamorph
