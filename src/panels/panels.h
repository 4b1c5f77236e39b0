// The panels of the window, one function each, one file each. They read the workspace, and change the level
// through its session only. Needs a current Dear ImGui context; none of them draws by OpenGL.
#pragma once

#include "edit/workspace.h"
#include "panels/ui_state.h"

namespace anamorph {

/// All panels in their places, and the mouse in the 3D view. What was changed is in the session afterwards.
void drawPanels(Workspace& work, UiState& ui);

/// What lies over the 3D view and has to be as new as it: gizmo, labels, axes, legend, messages. To be called
/// after the workspace has advanced, in the same frame.
void drawViewOverlay(Workspace& work, UiState& ui);

void drawMenuBar(Workspace& work, UiState& ui);
void drawLevelPanel(Workspace& work, UiState& ui);
void drawLessonPanel(Workspace& work, UiState& ui);
void drawPropertiesPanel(Workspace& work, UiState& ui);
void drawPreviewPanel(Workspace& work, UiState& ui);
void drawStatusLine(Workspace& work, UiState& ui);
void drawHelpWindow(Workspace& work, UiState& ui);
void drawRenderWindow(Workspace& work, UiState& ui);
void drawExportWindow(Workspace& work, UiState& ui);
/// Points and badges of all lessons.
void drawProgressWindow(Workspace& work, UiState& ui);
/// The open step in large letters, and a mark around the mouse: for an audience.
void drawPresenter(Workspace& work, UiState& ui);
/// Five cards that show a newcomer around, in twenty seconds.
void drawTour(Workspace& work, UiState& ui);

/// Opens a tab of the properties, and selects its thing.
void openTab(Workspace& work, UiState& ui, PropertyTab tab);

// The tabs of the properties panel.
void drawEyeProperties(Workspace& work, UiState& ui);
void drawOriginalProperties(Workspace& work, UiState& ui);
void drawMirrorProperties(Workspace& work, UiState& ui);
void drawSculptureProperties(Workspace& work, UiState& ui);
void drawLightProperties(Workspace& work, UiState& ui);
void drawRayProperties(Workspace& work, UiState& ui);
void drawViewProperties(Workspace& work, UiState& ui);

}  // namespace anamorph
