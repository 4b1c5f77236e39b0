// Which of the dialogs is on top: they lie over a dimmed window, get all keys, and have to be answered before
// anything else goes on. One is shown at a time.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// The name of the dialog that is open ("notice", "browser", "unsaved", "finish", "mesh", "recovery"); empty: none.
const char* openDialog(const UiState& ui);

/// Whether one is open: then keys are the dialog's.
bool isDialogOpen(const UiState& ui);

/// The dialog that is on top; takes the keys that were typed since the last frame.
void drawDialogs(Editor& editor, UiState& ui);

}  // namespace anamorph
