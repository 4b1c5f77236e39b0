// What the mouse is doing in the 3D view: a drag that goes on, a click that may become one.
#pragma once

#include <optional>

#include "edit/editor.h"
#include "edit/gizmo_drag.h"

namespace anamorph {

/// A drag in the 3D view that goes on.
enum class ViewDrag { none, orbit, pan, gizmo };

struct ViewMouse {
  ViewDrag drag = ViewDrag::none;
  std::optional<GizmoDrag> gizmoDrag;
  std::optional<GizmoHandle> hoveredHandle;
  bool clickPending = false;  ///< the mouse went down on nothing and has not moved yet
  int axisLock = -1;          ///< 0..2 while x, y or z is locked
};

/// Ends a drag that goes on, keeping or losing what it did.
void endViewDrag(Editor& editor, ViewMouse& mouse, bool keep);

/// Of a gizmo's drag: X, Y and Z lock their axis, and free it again. Returns whether the key meant something.
bool lockAxisByKey(ViewMouse& mouse, int key, int modifiers);

}  // namespace anamorph
