// The left panel: the levels, and below them what the open one is about.

#include <imgui.h>

#include "panels/actions.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void levelRow(const LevelEntry& entry, Workspace& work, UiState& ui) {
  const float s = static_cast<float>(ui.scale), height = 52 * s, gap = 8 * s;
  const bool open = isOpen(work, entry);
  ImGui::PushID(entry.name.c_str());
  const ImVec2 p = ImGui::GetCursorScreenPos();
  if (ImGui::Selectable("##level", open, 0, {0, height})) ui.requests.open = entry.path;
  tooltip(entry.problem.c_str());
  const ImVec2 after = ImGui::GetCursorScreenPos();
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float side = height - 6 * s;
  const ImVec2 low{p.x + 3 * s, p.y + 3 * s}, high{low.x + side, low.y + side};
  if (const auto picture = ui.textures.thumbnails.find(entry.name); picture != ui.textures.thumbnails.end()) {
    list->AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->second.id)), low,
                          high, {0, 0}, {1, 1}, IM_COL32_WHITE, 4 * s);
  } else {
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), 4 * s);
  }
  const std::string& title = entry.title.empty() ? entry.name : entry.title;
  const ImVec4 color =
      entry.problem.empty() ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : ink::bad(ui.preferences.theme);
  ImGui::SetCursorScreenPos({high.x + gap, p.y + (height - ImGui::GetTextLineHeight()) / 2});
  {
    const FontScope strong(open ? ui.fonts.strong : nullptr);
    ImGui::TextColored(color, "%s", title.c_str());
  }
  ImGui::SetCursorScreenPos(after);
  ImGui::PopID();
}

}  // namespace

void drawLevelPanel(Workspace& work, UiState& ui) {
  if (!beginPanel("levels", ui.layout.left)) return;
  {
    const FontScope strong(ui.fonts.strong);
    ImGui::TextUnformatted("Levels");
  }
  for (const LevelEntry& entry : ui.levels) levelRow(entry, work, ui);
  ImGui::Dummy({0, 6 * static_cast<float>(ui.scale)});
  ImGui::Separator();
  ImGui::Dummy({0, 4 * static_cast<float>(ui.scale)});
  const Level& level = work.session.level();
  {
    const FontScope title(ui.fonts.title);
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(level.title.empty() ? "A level without a title" : level.title.c_str());
    ImGui::PopTextWrapPos();
  }
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(level.description.c_str());
  ImGui::PopTextWrapPos();
  ImGui::Dummy({0, 6 * static_cast<float>(ui.scale)});
  if (wideButton("Reset the level", "As it was opened. Can be undone.", work.session.modified())) {
    perform(Action::resetLevel, work, ui);
  }
  ImGui::End();
}

}  // namespace anamorph
