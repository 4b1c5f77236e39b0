// The 3D view's picture and the mouse in it: orbit, pan, zoom, pick, drag a gizmo's handle.
#pragma once

#include "edit/workspace.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Shows the picture of the view and does what the mouse asks for.
void drawViewPanel(Workspace& work, UiState& ui);

/// The gizmo of the selection as it is; empty when there is none, or when the view is the RT camera's and the
/// gizmo would be its own.
struct ShownGizmo {
  Gizmo gizmo;
  GizmoFrame frame;
  GizmoMode mode = GizmoMode::move;
};
ShownGizmo currentGizmo(const Workspace& work, const UiState& ui);

/// Ends a drag in the view that goes on, keeping or losing what it did.
void endViewDrag(Workspace& work, UiState& ui, bool keep);

/// What is under a pixel of the view.
Pick pickAt(Workspace& work, const UiState& ui, const Pixel& pixel);

}  // namespace anamorph
