// Windows that have to be answered before anything else goes on: they lie over a dimmed window and get all
// keys. One is shown at a time.
#pragma once

#include <initializer_list>
#include <string>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Whether one is open: then keys are the dialog's.
bool isDialogOpen(const UiState& ui);

/// The dialog that is on top; takes the keys that were typed since the last frame.
void drawDialogs(Editor& editor, UiState& ui);

/// A dialog in the middle of the window, `width` and `height` at 100 %, never larger than the window; height
/// 0: as high as what is in it. `title` is English. Pair with endDialog() when it returns true.
bool beginDialog(const UiState& ui, const char* title, float width, float height = 0);
void endDialog();

/// Whether the key (panels/actions.h, keys) was typed for this dialog.
bool dialogKey(const UiState& ui, int key);

/// A row of buttons at the right end, one below the other where there is no room; the first one is the one
/// that Enter means. Returns which was pressed, or -1.
int dialogButtons(std::initializer_list<const char*> names, std::initializer_list<bool> enabled = {});
/// How wide that row is.
float dialogButtonsWidth(std::initializer_list<const char*> names);

void drawUnsavedDialog(Editor& editor, UiState& ui);
void drawRecoveryDialog(UiState& ui);
void drawNotice(UiState& ui);

}  // namespace anamorph
