// The panels of the window, one function each, one file each. They read the editor, and change the level
// through its session only. Needs a current Dear ImGui context; none of them draws by OpenGL.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// All panels in their places, and the mouse in the 3D view. What was changed is in the session afterwards.
void drawPanels(Editor& editor, UiState& ui);

/// What lies over the 3D view and has to be as new as it: gizmo, labels, axes, legend, messages. To be called
/// after the editor has advanced, in the same frame.
void drawViewOverlay(Editor& editor, UiState& ui);

void drawMenuBar(Editor& editor, UiState& ui);
void drawLevelPanel(Editor& editor, UiState& ui);
void drawLessonPanel(Editor& editor, UiState& ui);
void drawPropertiesPanel(Editor& editor, UiState& ui);
void drawPreviewPanel(Editor& editor, UiState& ui);
void drawStatusLine(Editor& editor, UiState& ui);
void drawHelpWindow(Editor& editor, UiState& ui);
/// The open step in large letters, and a mark around the mouse: for an audience.
void drawPresenter(Editor& editor, UiState& ui);

// The tabs of the properties panel.
void drawEyeProperties(Editor& editor, UiState& ui);
void drawOriginalProperties(Editor& editor, UiState& ui);
void drawMirrorProperties(Editor& editor, UiState& ui);
void drawSculptureProperties(Editor& editor, UiState& ui);
void drawLightProperties(Editor& editor, UiState& ui);
void drawRayProperties(Editor& editor, UiState& ui);
void drawViewProperties(Editor& editor, UiState& ui);

}  // namespace anamorph
