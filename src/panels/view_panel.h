// The mouse in the 3D view: orbit, pan, zoom, pick, drag a gizmo's handle.
#pragma once

#include <optional>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Does what the mouse asks for in the view.
void handleView(Editor& editor, UiState& ui);

/// The gizmo of the selection as it is; empty when there is none, when the view is the RT camera's and the gizmo would be
/// its own, and of the original while a construction is shown. The sculpture's is the handle of the depth scale.
struct ShownGizmo {
  Gizmo gizmo;
  GizmoFrame frame;
  GizmoMode mode = GizmoMode::move;
  std::optional<ConstructionLabel> label;  ///< beside it
};
ShownGizmo currentGizmo(const Editor& editor, const Look& look);

/// What is under a pixel of the view.
Pick pickAt(Editor& editor, const Look& look, const Pixel& pixel);

}  // namespace anamorph
