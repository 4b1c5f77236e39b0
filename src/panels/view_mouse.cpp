#include "panels/view_mouse.h"

#include "panels/keys.h"

namespace anamorph {

void endViewDrag(Editor& editor, ViewMouse& mouse, bool keep) {
  if (mouse.drag == ViewDrag::gizmo) {
    editor.status.clear();  // how far it was dragged; what is to be known of the sculpture comes again
    if (keep) {
      editor.session.finishChange();
    } else {
      editor.session.cancelChange();
    }
    mouse.gizmoDrag.reset();
    mouse.axisLock = -1;
  }
  mouse.drag = ViewDrag::none;
}

bool lockAxisByKey(ViewMouse& mouse, int key, int modifiers) {
  if (mouse.drag != ViewDrag::gizmo || key < 'X' || key > 'Z' || (modifiers & keys::control) != 0)
    return false;
  const int axis = key - 'X';
  mouse.axisLock = mouse.axisLock == axis ? -1 : axis;
  return true;
}

}  // namespace anamorph
