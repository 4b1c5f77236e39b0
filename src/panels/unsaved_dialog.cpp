// What is to become of changes that are not saved, before the level is left.

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/dialog.h"
#include "panels/file_flow.h"

namespace anamorph {
namespace {

enum class Answer { none = -1, save, drop, cancel };

Answer ask(const Workspace& work, const UiState& ui) {
  const Level& level = work.session.level();
  const std::string title = level.title.empty() ? std::string(tr("This level")) : tr(level.title);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(
      fmt::format(fmt::runtime(tr("\"{}\" has changes that are not saved. Without saving they are lost.")),
                  title)
          .c_str());
  if (!work.session.path().empty()) {
    ImGui::TextDisabled("%s", work.session.path().string().c_str());
  }
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, 6 * static_cast<float>(ui.scale)});
  const auto pressed = static_cast<Answer>(dialogButtons({"Save", "Don't save", "Cancel"}));
  if (dialogKey(ui, keys::enter) || dialogKey(ui, keys::padEnter)) return Answer::save;
  if (dialogKey(ui, 'D')) return Answer::drop;
  return dialogKey(ui, keys::escape) ? Answer::cancel : pressed;
}

}  // namespace

void drawUnsavedDialog(Workspace& work, UiState& ui) {
  if (!beginDialog(ui, "Save the changes?", 480)) return;
  const Answer answer = ask(work, ui);
  if (answer != Answer::none) ImGui::CloseCurrentPopup();
  endDialog();
  if (answer == Answer::cancel) ui.unsaved.reset();
  if (answer == Answer::drop) ui.unsaved->answer = UnsavedQuestion::Answer::drop;
  if (answer == Answer::save) {
    ui.unsaved->answer = UnsavedQuestion::Answer::save;
    saveCurrent(work, ui);
  }
}

}  // namespace anamorph
