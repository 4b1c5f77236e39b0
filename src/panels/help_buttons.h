// Buttons that find what would be long to find by trying (edit/level_helpers.h, level_repairs.h), for the
// panels and the box that says what is wrong.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Begin the search for the largest original that the mirror shows, or for its place behind it, in the background; while
/// one runs, how far it is and a way to stop it. Grey while the sculpture is frozen.
void originalButtons(Editor& editor);
/// Likewise for an eye that nothing stands in the way of.
void liftButton(Editor& editor);

/// The same without a button.
void startFit(Editor& editor);
void startBehind(Editor& editor);
void startLift(Editor& editor);

}  // namespace anamorph
