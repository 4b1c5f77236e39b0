// Buttons that find what would be long to find by trying (edit/level_helpers.h, level_repairs.h), for the
// panels and the box that says what is wrong.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Makes the original as large as the mirror allows; a notice when no size will do.
void fitButton(Editor& editor, UiState& ui);
/// Puts the original behind the mirror.
void behindButton(Editor& editor);
/// Begins the search for an eye that nothing stands in the way of, in the background; while it runs, how far
/// it is and a way to stop it.
void liftButton(Editor& editor);

/// The same without a button.
void fitOriginal(Editor& editor, UiState& ui);
void startLift(Editor& editor);

}  // namespace anamorph
