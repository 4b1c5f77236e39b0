// Small windows over the 3D view: buttons, what is wrong and how to mend it, the rays' legend.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

void drawViewButtons(Editor& editor, UiState& ui);
/// Nothing when all is well.
void drawProblem(Editor& editor, UiState& ui);
/// What the view shows otherwise than usual, a frozen sculpture above all, each with the way back; nothing when all is as
/// usual.
void drawViewSigns(Editor& editor, UiState& ui);
/// What of the level the 3D view cannot show, in a corner of it; nothing when it shows all.
void drawViewProblem(const UiState& ui);
/// What was said last, in full, until it has been read: for words that have no room in the status line.
void drawLongMessage(Editor& editor, const UiState& ui);
/// That the rays stand still, and what lets them go on; nothing while they do not.
void drawPausedRays(const Editor& editor, const UiState& ui);
void drawLegend(const Editor& editor, const UiState& ui);
/// All kinds of lines with their names, for the help.
void drawAllLegendLines(const UiState& ui);

}  // namespace anamorph
