#include "panels/recovery_dialog.h"

#include <algorithm>

#include <imgui.h>

#include "base/language.h"
#include "panels/dialog.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void entryRow(RecoveryDialog& dialog, std::size_t index, const Look& look) {
  const RecoveryEntry& entry = dialog.entries[index];
  const float line = ImGui::GetTextLineHeightWithSpacing();
  ImGui::PushID(static_cast<int>(index));
  const ImVec2 p = ImGui::GetCursorPos();
  if (ImGui::Selectable("##entry", index == dialog.selected, 0, {0, 2 * line})) dialog.selected = index;
  const ImVec2 after = ImGui::GetCursorPos();
  ImGui::SetCursorPos(p);
  {
    const FontScope strong(look.fonts.strong);
    ImGui::TextUnformatted(inOneLine(entry.title).c_str());
  }
  ImGui::SameLine();
  ImGui::TextDisabled("%s", entry.time.c_str());
  ImGui::SetCursorPos({p.x, p.y + line});
  if (!entry.problem.empty()) {
    ImGui::TextColored(ink::bad(look.theme), "%s", entry.problem.c_str());
  } else if (entry.fileIsNewer) {
    ImGui::TextColored(ink::bad(look.theme), "%s",
                       trFormat("The file is newer: {}", entry.level.string()).c_str());
  } else {
    ImGui::TextDisabled(
        "%s", entry.level.empty() ? tr("It was not saved to a file yet") : entry.level.string().c_str());
  }
  tooltip(entry.problem.c_str());
  ImGui::SetCursorPos(after);
  ImGui::PopID();
}

void moveSelection(RecoveryDialog& dialog, const DialogKeys& typed) {
  const std::size_t last = dialog.entries.size() - 1;
  dialog.selected = std::min(dialog.selected, last);
  if (isTyped(typed, keys::down)) dialog.selected = std::min(dialog.selected + 1, last);
  if (isTyped(typed, keys::up) && dialog.selected > 0) --dialog.selected;
}

// The first button is what Enter means: of two states of a level the newer one.
std::optional<RecoveryAnswer::Kind> askFor(const RecoveryEntry& entry, const DialogKeys& typed) {
  using Kind = RecoveryAnswer::Kind;
  const bool sound = entry.problem.empty();
  const int pressed = entry.fileIsNewer
                          ? dialogButtons({"Keep the file", "Restore the older", "Decide later"})
                          : dialogButtons({"Restore", "Discard", "Decide later"}, {sound});
  const Kind first = entry.fileIsNewer ? Kind::discard : Kind::restore,
             second = entry.fileIsNewer ? Kind::restore : Kind::discard;
  if (isTyped(typed, keys::escape) || pressed == 2) return Kind::later;
  if ((sound && isEnterTyped(typed)) || pressed == 0) return first;
  return pressed == 1 ? std::optional(second) : std::nullopt;
}

}  // namespace

std::optional<RecoveryAnswer> drawRecoveryDialog(RecoveryDialog& dialog, const DialogKeys& typed,
                                                 const Look& look) {
  moveSelection(dialog, typed);
  if (!beginDialog(look, "Restore unsaved work?", 560)) return std::nullopt;
  paragraph(tr("Anamorph ended before this was saved. It is as it was a short time before:"));
  // As many as there are, at most four, and no more than leave room for the buttons.
  const ImGuiStyle& style = ImGui::GetStyle();
  const float row = 2 * ImGui::GetTextLineHeightWithSpacing() + style.ItemSpacing.y;
  const float room = 0.97f * ImGui::GetIO().DisplaySize.y - ImGui::GetCursorPosY() -
                     ImGui::GetFrameHeightWithSpacing() - style.WindowPadding.y;
  const float height =
      std::clamp(room, 0.5f * row, row * static_cast<float>(std::min<std::size_t>(dialog.entries.size(), 4)));
  ImGui::BeginChild("entries", {0, height});
  for (std::size_t i = 0; i < dialog.entries.size(); ++i) entryRow(dialog, i, look);
  ImGui::EndChild();
  const auto kind = askFor(dialog.entries[dialog.selected], typed);
  endDialog();
  if (!kind) return std::nullopt;
  return RecoveryAnswer{*kind, dialog.selected};
}

}  // namespace anamorph
