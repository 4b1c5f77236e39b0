// What the viewing sheet says in words: the steps in which a maker sets things up.
#pragma once

#include <string>
#include <vector>

#include "exports/arrangement.h"
#include "exports/page.h"

namespace anamorph {

/// A paragraph of the sheet; its name stands in bold, in its colour, before the text.
struct SheetStep {
  std::string name;
  std::string text;
  Color color{0};
};

/// "1 : 2", "5 : 1"
std::string scaleName(double scale);

std::vector<SheetStep> makeSheetSteps(const Arrangement& arrangement, double scale);

}  // namespace anamorph
