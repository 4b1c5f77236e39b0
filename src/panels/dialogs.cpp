#include "panels/dialogs.h"

#include <string>
#include <vector>

#include "panels/browser_view.h"
#include "panels/file_flow.h"
#include "panels/level_sharing.h"

namespace anamorph {
namespace {

using Draw = void (*)(Editor&, UiState&);
using IsOpen = bool (*)(const UiState&);

struct Dialog {
  const char* name;
  IsOpen isOpen;
  Draw draw;
};

// The upper ones lie over the lower ones.
constexpr Dialog dialogs[] = {
    {"notice", [](const UiState& ui) { return ui.notice.has_value(); },
     [](Editor&, UiState& ui) { drawNotice(ui.notice, ui.dialogKeys, ui); }},
    {"browser", [](const UiState& ui) { return ui.browser.open; },
     [](Editor&, UiState& ui) { drawFileBrowser(ui.browser, ui.dialogKeys, ui); }},
    {"unsaved", [](const UiState& ui) { return ui.unsaved.has_value(); },
     [](Editor& editor, UiState& ui) {
       if (drawUnsavedDialog(editor, ui.unsaved, ui.dialogKeys, ui)) saveCurrent(editor, ui);
     }},
    {"finish", [](const UiState& ui) { return ui.finish.has_value(); },
     [](Editor& editor, UiState& ui) {
       drawFinishDialog(ui.finish, filesBeingWritten(editor, ui), ui.exporting.fraction, ui.dialogKeys, ui);
     }},
    {"mesh", [](const UiState& ui) { return ui.meshQuestion.has_value(); },
     [](Editor& editor, UiState& ui) {
       if (const auto answer = drawMeshDialog(*ui.meshQuestion, ui.dialogKeys, ui))
         answerMeshQuestion(*answer, editor, ui);
     }},
    {"recovery", [](const UiState& ui) { return !ui.recovery.entries.empty(); },
     [](Editor&, UiState& ui) {
       if (const auto answer = drawRecoveryDialog(ui.recovery, ui.dialogKeys, ui))
         ui.requests.recovery = answer;
     }},
};

const Dialog* topmost(const UiState& ui) {
  for (const Dialog& dialog : dialogs) {
    if (dialog.isOpen(ui)) return &dialog;
  }
  return nullptr;
}

}  // namespace

const char* openDialog(const UiState& ui) {
  const Dialog* dialog = topmost(ui);
  return dialog ? dialog->name : "";
}

bool isDialogOpen(const UiState& ui) {
  return topmost(ui) != nullptr;
}

void drawDialogs(Editor& editor, UiState& ui) {
  if (const Dialog* dialog = topmost(ui)) dialog->draw(editor, ui);
  ui.dialogKeys.clear();
}

}  // namespace anamorph
