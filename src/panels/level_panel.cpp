// The level list: a picture, the title, and how far its lesson is done.

#include <cstring>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void drawThumbnail(const LevelEntry& entry, const UiState& ui, const ImVec2& low, const ImVec2& high) {
  const float rounding = 4 * static_cast<float>(ui.scale);
  ImDrawList* list = ImGui::GetWindowDrawList();
  const auto picture = ui.textures.thumbnails.find(entry.name);
  if (picture == ui.textures.thumbnails.end()) {
    list->AddRectFilled(low, high, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
    return;
  }
  list->AddImageRounded(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(picture->second.id)), low,
                        high, {0, 0}, {1, 1}, IM_COL32_WHITE, rounding);
}

// "3 of 7", a star once the badge is earned.
void drawProgress(const LevelEntry& entry, const Editor& editor, const UiState& ui, float right,
                  float middle) {
  if (entry.lesson.steps.empty()) return;
  const LessonScore score = scoreOf(entry.lesson, editor.progress);
  const float size = ImGui::GetFontSize();
  if (score.badge) return drawStar({right - size / 2, middle}, 0.48f * size);
  const std::string text = fmt::format("{}/{}", score.done, score.steps);
  const ImVec2 extent = ImGui::CalcTextSize(text.c_str());
  ImGui::GetWindowDrawList()->AddText({right - extent.x, middle - extent.y / 2},
                                      ImGui::ColorConvertFloat4ToU32(ink::quiet(ui.theme)), text.c_str());
}

void levelRow(const LevelEntry& entry, Editor& editor, UiState& ui) {
  const float s = static_cast<float>(ui.scale), height = levelRowHeight * s, gap = 8 * s;
  const bool open = isOpen(editor, entry);
  ImGui::PushID(entry.name.c_str());
  const ImVec2 p = ImGui::GetCursorScreenPos();
  const float right = p.x + ImGui::GetContentRegionAvail().x - 4 * s;
  if (ImGui::Selectable("##level", open, 0, {0, height})) {
    ui.requests.open = entry.path;
    ui.levelsOpen = false;
  }
  tooltip(entry.problem.c_str());
  const ImVec2 after = ImGui::GetCursorScreenPos();
  const float side = height - 6 * s;
  const ImVec2 low{p.x + 3 * s, p.y + 3 * s}, high{low.x + side, low.y + side};
  drawThumbnail(entry, ui, low, high);
  drawProgress(entry, editor, ui, right, p.y + height / 2);
  const std::string title = inOneLine(entry.title.empty() ? entry.name : tr(entry.title));
  const ImVec4 color = entry.problem.empty() ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : ink::bad(ui.theme);
  ImGui::SetCursorScreenPos({high.x + gap, p.y + (height - ImGui::GetTextLineHeight()) / 2});
  {
    const FontScope strong(open ? ui.fonts.strong : nullptr);
    ImGui::PushClipRect(p, {right - 34 * s, p.y + height}, true);
    ImGui::TextColored(color, "%s", title.c_str());
    ImGui::PopClipRect();
  }
  ImGui::SetCursorScreenPos(after);
  ImGui::PopID();
}

void drawGroup(const char* title, const UiState& ui) {
  const float above = 6 * static_cast<float>(ui.scale);
  ImGui::Dummy({0, above});
  ImGui::TextColored(ink::quiet(ui.theme), "%s", tr(title));
}

// With an arrow where the list can be folded.
void drawHeading(UiState& ui) {
  const FontScope strong(ui.fonts.strong);
  if (!ui.layout.levelsFolded && !ui.levelsOpen) return ImGui::TextUnformatted(tr("Levels"));
  ImGui::SetNextItemOpen(ui.levelsOpen);
  ui.levelsOpen = ImGui::CollapsingHeader(label("Levels").c_str());
}

}  // namespace

void drawLevelPanel(Editor& editor, UiState& ui) {
  if (!beginPanel("levels", ui.layout.left, true, !ui.layout.levelsFolded)) return;
  drawHeading(ui);
  if (ui.layout.levelsFolded) return ImGui::End();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0});
  const char* group = "";
  for (const LevelEntry& entry : ui.levels) {
    if (std::strcmp(group, entry.group) != 0) drawGroup(group = entry.group, ui);
    levelRow(entry, editor, ui);
  }
  ImGui::PopStyleVar();
  ImGui::End();
}

}  // namespace anamorph
