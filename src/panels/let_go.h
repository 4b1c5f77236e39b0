// Before something takes the level's place: what is being dragged, or typed into, works on the old one.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// A drag in the view ends, with its effect, and widgets are let go of.
void letGo(Editor& editor, UiState& ui);

/// The same, and what was being changed becomes a step of its own.
void finishEdits(Editor& editor, UiState& ui);

}  // namespace anamorph
