#include "panels/key_input.h"

#include "panels/actions.h"
#include "panels/dialogs.h"
#include "panels/export_window.h"
#include "panels/key_focus.h"
#include "panels/view_mouse.h"

namespace anamorph {

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
  const ActionRow* row = findAction({key, modifiers}, ui.preferences.vrtKeys);
  if (row) perform(row->action, editor, ui);
  return row != nullptr;
}

}  // namespace anamorph
