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
#include <vector>

namespace anamorph {

struct KeyFocus {
  std::string window;    ///< that has the keyboard, as Dear ImGui calls it; empty: the 3D view
  bool entered = false;  ///< it is to get it in this frame
};

/// To the next (`direction` 1) or last (-1) of the windows that can be reached now.
void moveKeyFocus(KeyFocus& focus, const std::vector<std::string>& reachable, int direction);
void leaveKeyFocus(KeyFocus& focus);

/// Whether this key (panels/keys.h) is the panel's now and no shortcut: those that move and type, while a
/// panel has the keyboard.
bool isForPanel(const KeyFocus& focus, int key, int modifiers);

/// Once a frame, after the layout is known and before the panels are drawn: gives the keyboard to the panel that is
/// to have it, and to its first control. `rests`: a dialog has keys of its own, and gives them back when it closes.
void updateKeyFocus(KeyFocus& focus, const std::vector<std::string>& reachable, bool rests);

}  // namespace anamorph
