#include "panels/let_go.h"

#include "panels/view_mouse.h"
#include "panels/widgets.h"

namespace anamorph {

void letGo(Editor& editor, UiState& ui) {
  endViewDrag(editor, ui.mouse, true);
  letGoOfWidgets();
}

void finishEdits(Editor& editor, UiState& ui) {
  letGo(editor, ui);
  editor.session.finishChange();
}

}  // namespace anamorph
