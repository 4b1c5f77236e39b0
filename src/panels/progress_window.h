// Points and badges: what the student has done in all lessons, and a way to begin anew.
#pragma once

#include <vector>

#include "edit/editor.h"
#include "level/level_library.h"
#include "panels/look.h"

namespace anamorph {

struct ProgressWindow {
  bool open = false;
  bool resetAsked = false;  ///< whether progress is really to be forgotten
};

void drawProgressWindow(ProgressWindow& window, Editor& editor, const std::vector<LevelEntry>& levels,
                        const Look& look);

}  // namespace anamorph
