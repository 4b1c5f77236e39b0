// The panels of the window, one function each, one file each. They read the editor, and change the level
// through its session only. Needs a current Dear ImGui context; none of them draws by OpenGL.
#pragma once

#include "edit/editor.h"
#include "panels/match_score.h"
#include "panels/ui_state.h"

namespace anamorph {

/// A frame begins: where everything is, and what mouse and keys do in the 3D view. The editor advances afterwards,
/// so that what is dragged in the view is seen there in the same frame.
void handleInput(Editor& editor, UiState& ui);

/// All panels in their places, with what the editor has made, and what lies over the 3D view. What is changed in
/// them is in the session afterwards, and seen in the next frame.
void drawPanels(Editor& editor, UiState& ui);

/// The 3D view's picture and what lies over it: gizmo, labels, axes, legend, messages.
void drawView(Editor& editor, UiState& ui);
void drawMenuBar(Editor& editor, UiState& ui, const MatchScore& score);
void drawLevelPanel(Editor& editor, UiState& ui);
void drawLessonPanel(Editor& editor, UiState& ui);
void drawPropertiesPanel(Editor& editor, UiState& ui);
void drawPreviewPanel(Editor& editor, UiState& ui, const MatchScore& score);
void drawStatusLine(Editor& editor, UiState& ui);
void drawHelpWindow(Editor& editor, UiState& ui);
/// The open step in large letters, and a mark around the mouse: for an audience.
void drawPresenter(Editor& editor, UiState& ui);
/// Pixels that those letters need at the window's width, the same before and after the step is done; 0 when nothing is
/// presented.
float presenterHeight(const Editor& editor, const UiState& ui);

// The tabs of the properties panel.
void drawEyeProperties(Editor& editor, UiState& ui);
void drawOriginalProperties(Editor& editor, UiState& ui);
void drawMirrorProperties(Editor& editor, UiState& ui);
void drawSculptureProperties(Editor& editor, UiState& ui);
void drawLightProperties(Editor& editor, UiState& ui);
void drawRayProperties(Editor& editor, UiState& ui);
void drawViewProperties(Editor& editor, UiState& ui);

}  // namespace anamorph
