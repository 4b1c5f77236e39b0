// What is where: cards beside the parts of the window that they tell of. Each waits until it has been read; all can be
// skipped at once, and the menu Help shows them again.
#pragma once

#include "panels/layout.h"
#include "panels/look.h"
#include "panels/preferences.h"

namespace anamorph {

struct Tour {
  int card = -1;  ///< that is shown; -1: none is

  bool goesOn() const { return card >= 0; }
};

constexpr int tourCards = 6;

void startTour(Tour& tour);
/// Seen or skipped: it does not come by itself again.
void endTour(Tour& tour, Preferences& preferences);
/// `tabs`: where the tabs of the properties were drawn.
void drawTour(Tour& tour, Preferences& preferences, const Layout& layout, const Rect& tabs, const Look& look);

}  // namespace anamorph
