#include "panels/unsaved_dialog.h"

#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/dialog.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

std::string leftTitles(const Editor& editor) {
  std::string titles;
  for (const auto& [path, level] : editor.leftLevels) {
    titles += (titles.empty() ? "" : ", ") +
              inOneLine(tr(level.text->title.empty() ? path.stem().string() : level.text->title));
  }
  return titles;
}

enum class Answer { none = -1, save, drop, cancel };

void aboutThisLevel(const Editor& editor, const Look& look) {
  const Level& level = editor.session.level();
  const std::string title =
      inOneLine(level.text->title.empty() ? tr("This level") : tr(level.text->title).c_str());
  paragraph(trFormat("\"{}\" has changes that are not saved. Without saving they are lost.", title));
  if (editor.session.isInstalled()) {
    quietText(look, "The level itself stays as it is: you save a copy of your own.");
  } else if (!editor.session.path().empty()) {
    quietText(look, editor.session.path().c_str());
  }
}

Answer ask(const Editor& editor, const UnsavedQuestion& question, const DialogKeys& typed, const Look& look) {
  const bool modified = editor.session.modified();
  if (modified) aboutThisLevel(editor, look);
  if (question.next == UnsavedQuestion::Next::quit && !editor.leftLevels.empty()) {
    paragraph(trFormat("Changed and left without saving: {}. The next time they are as they were.",
                       leftTitles(editor)));
  }
  ImGui::Dummy({0, 6 * static_cast<float>(look.scale)});
  const bool enter = isEnterTyped(typed);
  if (isTyped(typed, keys::escape)) return Answer::cancel;
  if (!modified) {
    const int pressed = dialogButtons({"Quit", "Cancel"});
    return enter || pressed == 0 ? Answer::drop : pressed == 1 ? Answer::cancel : Answer::none;
  }
  const auto pressed = static_cast<Answer>(dialogButtons({"Save", "Don't save", "Cancel"}));
  if (enter) return Answer::save;
  return isTyped(typed, 'D') ? Answer::drop : pressed;
}

}  // namespace

bool drawUnsavedDialog(const Editor& editor, std::optional<UnsavedQuestion>& question,
                       const DialogKeys& typed, const Look& look) {
  if (!beginDialog(look, "Save the changes?", 480)) return false;
  const Answer answer = ask(editor, *question, typed, look);
  if (answer != Answer::none) ImGui::CloseCurrentPopup();
  endDialog();
  if (answer == Answer::cancel) question.reset();
  if (answer == Answer::drop) question->answer = UnsavedQuestion::Answer::drop;
  if (answer == Answer::save) question->answer = UnsavedQuestion::Answer::save;
  return answer == Answer::save;
}

}  // namespace anamorph
