// The panels by keys alone. F6 puts the keyboard into the next panel or open window, and after the last one
// back into the 3D view:
//
//     3D view --> levels --> lesson --> properties --> preview --> open windows --.
//        ^-----------------------------------------------------------------------'
//
// There the arrows go from control to control, Enter types into a number, Space presses a button or begins to
// change a number with the arrows. Esc or a click goes back to the 3D view, whose keys then work again.
#pragma once

#include <string>

#include "panels/ui_state.h"

namespace anamorph {

/// `direction`: 1 or -1.
void moveKeyFocus(UiState& ui, int direction);
void leaveKeyFocus(UiState& ui);

/// Whether this key (panels/actions.h, keys) is the panel's now and no shortcut: those that move and type,
/// while a panel has the keyboard.
bool isForPanel(const UiState& ui, int key, int modifiers);

/// Once a frame, after the layout is known and before the panels are drawn: gives the keyboard to the panel that is
/// to have it, and to its first control.
void updateKeyFocus(UiState& ui);

}  // namespace anamorph
