// The mouse in the 3D view: orbit, pan, zoom, pick, drag a gizmo's handle.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Does what the mouse asks for in the view.
void handleView(Editor& editor, UiState& ui);

/// The gizmo of the selection as it is; empty when there is none, or when the view is the RT camera's and the
/// gizmo would be its own.
struct ShownGizmo {
  Gizmo gizmo;
  GizmoFrame frame;
  GizmoMode mode = GizmoMode::move;
};
ShownGizmo currentGizmo(const Editor& editor, const Look& look);

/// What is under a pixel of the view.
Pick pickAt(Editor& editor, const Look& look, const Pixel& pixel);

}  // namespace anamorph
