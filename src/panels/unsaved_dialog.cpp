// What is to become of changes that are not saved, before the level is left.

#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/dialog.h"
#include "panels/file_flow.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

std::string leftTitles(const Editor& editor) {
  std::string titles;
  for (const auto& [path, level] : editor.leftLevels) {
    titles += (titles.empty() ? "" : ", ") + tr(level.text->title.empty() ? path.stem().string() : level.text->title);
  }
  return titles;
}

enum class Answer { none = -1, save, drop, cancel };

void aboutThisLevel(const Editor& editor, const UiState& ui) {
  const Level& level = editor.session.level();
  const std::string title = level.text->title.empty() ? std::string(tr("This level")) : tr(level.text->title);
  paragraph(fmt::format(
      fmt::runtime(tr("\"{}\" has changes that are not saved. Without saving they are lost.")), title));
  if (editor.session.isInstalled()) {
    quietText(ui, "The level itself stays as it is: you save a copy of your own.");
  } else if (!editor.session.path().empty()) {
    quietText(ui, editor.session.path().c_str());
  }
}

Answer ask(const Editor& editor, const UiState& ui) {
  const bool modified = editor.session.modified();
  if (modified) aboutThisLevel(editor, ui);
  if (ui.unsaved->next == UnsavedQuestion::Next::quit && !editor.leftLevels.empty()) {
    paragraph(fmt::format(
        fmt::runtime(tr("Changed and left without saving: {}. The next time they are as they were.")),
        leftTitles(editor)));
  }
  ImGui::Dummy({0, 6 * static_cast<float>(ui.scale)});
  const bool enter = dialogKey(ui, keys::enter) || dialogKey(ui, keys::padEnter);
  if (dialogKey(ui, keys::escape)) return Answer::cancel;
  if (!modified) {
    const int pressed = dialogButtons({"Quit", "Cancel"});
    return enter || pressed == 0 ? Answer::drop : pressed == 1 ? Answer::cancel : Answer::none;
  }
  const auto pressed = static_cast<Answer>(dialogButtons({"Save", "Don't save", "Cancel"}));
  if (enter) return Answer::save;
  return dialogKey(ui, 'D') ? Answer::drop : pressed;
}

}  // namespace

void drawUnsavedDialog(Editor& editor, UiState& ui) {
  if (!beginDialog(ui, "Save the changes?", 480)) return;
  const Answer answer = ask(editor, ui);
  if (answer != Answer::none) ImGui::CloseCurrentPopup();
  endDialog();
  if (answer == Answer::cancel) ui.unsaved.reset();
  if (answer == Answer::drop) ui.unsaved->answer = UnsavedQuestion::Answer::drop;
  if (answer == Answer::save) {
    ui.unsaved->answer = UnsavedQuestion::Answer::save;
    saveCurrent(editor, ui);
  }
}

}  // namespace anamorph
