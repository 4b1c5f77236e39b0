// The file browser on the screen; what it does is in file_browser.cpp.
#pragma once

#include "panels/browser_state.h"
#include "panels/keys.h"
#include "panels/look.h"

namespace anamorph {

/// Shows it and does what the mouse and the keys typed since the last frame ask for.
void drawFileBrowser(FileBrowser& browser, const DialogKeys& typed, const Look& look);

}  // namespace anamorph
