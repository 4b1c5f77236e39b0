// Small windows over the 3D view: buttons, what is wrong and how to mend it, the rays' legend.
#pragma once

#include "edit/workspace.h"
#include "panels/ui_state.h"

namespace anamorph {

void drawViewButtons(Workspace& work, UiState& ui);
/// Nothing when all is well.
void drawProblem(Workspace& work, UiState& ui);
void drawLegend(const Workspace& work, const UiState& ui);
/// All kinds of lines with their names, for the help.
void drawAllLegendLines(const UiState& ui);

}  // namespace anamorph
