// What dialogs are made of: windows that have to be answered before anything else goes on (panels/dialogs.h has them).
#pragma once

#include <initializer_list>

#include "panels/look.h"

namespace anamorph {

/// A dialog in the middle of the window, `width` and `height` at 100 %, never larger than the window; height
/// 0: as high as what is in it. `title` is English. Pair with endDialog() when it returns true.
bool beginDialog(const Look& look, const char* title, float width, float height = 0);
void endDialog();

/// A row of buttons at the right end, one below the other where there is no room; the first one is the one
/// that Enter means. Returns which was pressed, or -1.
int dialogButtons(std::initializer_list<const char*> names, std::initializer_list<bool> enabled = {});
/// How wide that row is.
float dialogButtonsWidth(std::initializer_list<const char*> names);

}  // namespace anamorph
