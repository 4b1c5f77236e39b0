// What is where: five cards of four seconds, each beside the part of the window that it tells of. Any of them
// can be skipped, all of them at once, and the menu Help shows them again.
#pragma once

#include "panels/layout.h"
#include "panels/look.h"
#include "panels/preferences.h"

namespace anamorph {

struct Tour {
  int card = -1;       ///< that is shown; -1: none is
  double seconds = 0;  ///< since it appeared

  bool goesOn() const { return card >= 0; }
};

void startTour(Tour& tour);
/// Seen or skipped: it does not come by itself again.
void endTour(Tour& tour, Preferences& preferences);
void drawTour(Tour& tour, Preferences& preferences, const Layout& layout, const Look& look);

}  // namespace anamorph
