// What a key does: it is the dialog's, the panel's, the drag's, the presenter's, the export window's, or a shortcut of
// the table of actions, in this order.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// A key went down while no text is typed. Returns whether it meant something, be it of an action that cannot be done
/// now. While a dialog is open it gets the key, also while text is typed; `repeated`: it is held down.
bool handleKey(int key, int modifiers, Editor& editor, UiState& ui, bool repeated = false);

}  // namespace anamorph
