// Levels that an earlier session could not save any more, offered when the program starts.

#include <algorithm>

#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/dialog.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void entryRow(UiState& ui, std::size_t index) {
  const RecoveryEntry& entry = ui.recoveries[index];
  const float line = ImGui::GetTextLineHeightWithSpacing();
  ImGui::PushID(static_cast<int>(index));
  const ImVec2 p = ImGui::GetCursorPos();
  if (ImGui::Selectable("##entry", index == ui.recoverySelected, 0, {0, 2 * line}))
    ui.recoverySelected = index;
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(p);
  {
    const FontScope strong(ui.fonts.strong);
    ImGui::TextUnformatted(entry.title.c_str());
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%s", entry.time.c_str());
  ImGui::SetCursorPos({p.x, p.y + line});
  if (entry.problem.empty()) {
    ImGui::TextDisabled(
        "%s", entry.level.empty() ? tr("It was not saved to a file yet") : entry.level.string().c_str());
  } else {
    ImGui::TextColored(ink::bad(ui.preferences.theme), "%s", entry.problem.c_str());
  }
  tooltip(entry.problem.c_str());
  ImGui::SetCursorPos(after);
  ImGui::PopID();
}

void moveSelection(UiState& ui) {
  const std::size_t last = ui.recoveries.size() - 1;
  ui.recoverySelected = std::min(ui.recoverySelected, last);
  if (dialogKey(ui, keys::down)) ui.recoverySelected = std::min(ui.recoverySelected + 1, last);
  if (dialogKey(ui, keys::up) && ui.recoverySelected > 0) --ui.recoverySelected;
}

}  // namespace

void drawRecoveryDialog(UiState& ui) {
  moveSelection(ui);
  if (!beginDialog(ui, "Restore unsaved work?", 560)) return;
  paragraph(tr("Anamorph ended before this was saved. It is as it was a short time before:"));
  // As many as there are, at most four, and no more than leave room for the buttons.
  const ImGuiStyle& style = ImGui::GetStyle();
  const float row = 2 * ImGui::GetTextLineHeightWithSpacing() + style.ItemSpacing.y;
  const float room = 0.97f * ImGui::GetIO().DisplaySize.y - ImGui::GetCursorPosY() -
                     ImGui::GetFrameHeightWithSpacing() - style.WindowPadding.y;
  const float height =
      std::clamp(room, 0.5f * row, row * static_cast<float>(std::min<std::size_t>(ui.recoveries.size(), 4)));
  ImGui::BeginChild("entries", {0, height});
  for (std::size_t i = 0; i < ui.recoveries.size(); ++i) entryRow(ui, i);
  ImGui::EndChild();
  const bool sound = ui.recoveries[ui.recoverySelected].problem.empty();
  int pressed = dialogButtons({"Restore", "Discard", "Decide later"}, {sound});
  if (sound && (dialogKey(ui, keys::enter) || dialogKey(ui, keys::padEnter))) pressed = 0;
  if (dialogKey(ui, keys::escape)) pressed = 2;
  if (pressed >= 0) {
    ui.requests.recovery = RecoveryAnswer{static_cast<RecoveryAnswer::Kind>(pressed), ui.recoverySelected};
  }
  endDialog();
}

}  // namespace anamorph
