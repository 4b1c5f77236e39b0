#include "panels/key_input.h"

#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/dialogs.h"
#include "panels/export_window.h"
#include "panels/key_focus.h"
#include "panels/view_mouse.h"

namespace anamorph {

namespace {

// Whether a digit is more likely meant for a number: the mouse has just been clicked among them, beside the field itself.
bool isMeantForNumber(int key, int modifiers, const UiState& ui) {
  const bool isDigit = (key >= '0' && key <= '9') || (key >= keys::pad0 && key <= keys::pad0 + 9);
  if (!isDigit || modifiers != 0 || !ImGui::GetCurrentContext()) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const Rect& rows = ui.layout.properties;
  return rows.contains(io.MousePos.x, io.MousePos.y) &&
         rows.contains(io.MouseClickedPos[0].x, io.MouseClickedPos[0].y);
}

}  // namespace

bool handleKey(int key, int modifiers, Editor& editor, UiState& ui, bool repeated) {
  if (isDialogOpen(ui)) {
    if (modifiers == 0) ui.dialogKeys.push_back({key, repeated});
    return true;
  }
  if (isForPanel(ui.keyFocus, key, modifiers)) return true;
  if (lockAxisByKey(ui.mouse, key, modifiers)) return true;
  if (ui.presenting && modifiers == 0 && (key == keys::left || key == keys::right)) {
    perform(key == keys::left ? Action::previousStep : Action::nextStep, editor, ui);
    return true;
  }
  if (ui.exporting.open && modifiers == 0 && exportKey(ui.exporting, key)) return true;
  if (isMeantForNumber(key, modifiers, ui)) {
    editor.status.sayOf(editor.session.level(), tr("To type a number, double-click the number itself."));
    return true;
  }
  const ActionRow* row = findAction({key, modifiers}, ui.preferences.vrtKeys);
  if (row) perform(row->action, editor, ui);
  return row != nullptr;
}

}  // namespace anamorph
