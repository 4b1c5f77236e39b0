// The preview: what the RT camera sees, traced on the CPU, beside the original seen directly; and how well
// they match.

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/difference_legend.h"
#include "panels/highlight.h"
#include "panels/match_score.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

ImTextureID idOf(const UiTexture& texture) {
  return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture.id));
}

// The largest rectangle of the image's proportions in the middle of what is left of the panel.
Rect imageRect(const PixelGrid& grid, const ImVec2& at, const ImVec2& room) {
  const float aspect = static_cast<float>(grid.columns) / static_cast<float>(grid.rows);
  const float width = std::max(1.0f, std::min(room.x, room.y * aspect)),
              height = std::max(1.0f, width / aspect);
  return {at.x + (room.x - width) / 2, at.y + (room.y - height) / 2, width, height};
}

void drawPicture(const UiTexture& texture, const Rect& r, float from = 0, float to = 1) {
  if (texture.id == 0 || !(to > from)) return;
  ImGui::GetWindowDrawList()->AddImage(idOf(texture), {r.x + from * r.width, r.y},
                                       {r.x + to * r.width, r.y + r.height}, {from, 0}, {to, 1});
}

void drawCell(const Rect& r, const PixelGrid& grid, const GridCell& cell, ImU32 color, float thickness) {
  const float w = r.width / static_cast<float>(grid.columns), h = r.height / static_cast<float>(grid.rows);
  const float x = r.x + w * static_cast<float>(cell.column), y = r.y + h * static_cast<float>(cell.row);
  ImGui::GetWindowDrawList()->AddRect({x, y}, {x + w, y + h}, color, 0, 0, thickness);
}

// Hover outlines a cell of the pixel grid, a click isolates its rays, a second click shows all again.
void pointAtCell(Editor& editor, UiState& ui, const Rect& r) {
  const PixelGrid& grid = editor.session.level().grid;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const GridCell cell{
      std::clamp(static_cast<int>((mouse.x - r.x) / r.width * static_cast<float>(grid.columns)), 0,
                 grid.columns - 1),
      std::clamp(static_cast<int>((mouse.y - r.y) / r.height * static_cast<float>(grid.rows)), 0,
                 grid.rows - 1)};
  ui.hoveredCell = cell;
  if (!ImGui::IsItemClicked(0)) return;
  pickCell(editor, editor.cell == cell ? std::nullopt : std::optional(cell));
}

// The line between both pictures, with a grip.
void drawWipe(Editor& editor, const UiState& ui, const Rect& r) {
  const float x = r.x + static_cast<float>(editor.preview.wipe) * r.width,
              grip = 7 * static_cast<float>(ui.scale);
  ImDrawList* list = ImGui::GetWindowDrawList();
  list->AddLine({x, r.y}, {x, r.y + r.height}, IM_COL32(255, 255, 255, 230), 2);
  list->AddCircleFilled({x, r.y + r.height / 2}, grip, IM_COL32(255, 255, 255, 240));
}

void drawImages(Editor& editor, UiState& ui, const Rect& r) {
  const UiTextures& t = ui.textures;
  ImGui::GetWindowDrawList()->AddRectFilled({r.x, r.y}, {r.x + r.width, r.y + r.height},
                                            ImGui::GetColorU32(ImGuiCol_FrameBg));
  ImGui::SetCursorScreenPos({r.x, r.y});
  ImGui::InvisibleButton("image", {r.width, r.height});
  const bool hovered = ImGui::IsItemHovered(), active = ImGui::IsItemActive();
  highlightItem("Preview");
  switch (editor.preview.tab) {
    case PreviewTab::reflection:
      drawPicture(t.reflection, r);
      break;
    case PreviewTab::original:
      drawPicture(t.original, r);
      break;
    case PreviewTab::difference:
      drawPicture(t.difference, r);
      break;
    case PreviewTab::wipe:
      if (active) editor.preview.wipe = std::clamp((ImGui::GetIO().MousePos.x - r.x) / r.width, 0.0f, 1.0f);
      drawPicture(t.reflection, r, 0, static_cast<float>(editor.preview.wipe));
      drawPicture(t.original, r, static_cast<float>(editor.preview.wipe), 1);
      drawWipe(editor, ui, r);
      return;
  }
  const PixelGrid& grid = editor.session.level().grid;
  ui.hoveredCell.reset();
  if (hovered) pointAtCell(editor, ui, r);
  if (ui.hoveredCell) drawCell(r, grid, *ui.hoveredCell, IM_COL32(255, 255, 255, 200), 1.5f);
  if (editor.cell) drawCell(r, grid, *editor.cell, ink::of(palette::chosenCell), 2.5f);
}

// The tooltip has the parts that are not among the first `parts`, which are shown below.
void scoreBar(const UiState& ui, const MatchScore& score, std::size_t parts) {
  const float height = ImGui::GetFrameHeight();
  const ImVec2 p = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList* list = ImGui::GetWindowDrawList();
  const float rounding = ImGui::GetStyle().FrameRounding;
  list->AddRectFilled(p, {p.x + width, p.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg), rounding);
  ImVec4 fill = scoreColor(score, ui.theme);
  fill.w = 0.45f;
  const float filled = width * static_cast<float>(std::clamp(score.fraction, 0.0, 1.0));
  if (filled > 1)
    list->AddRectFilled(p, {p.x + filled, p.y + height}, ImGui::ColorConvertFloat4ToU32(fill), rounding);
  const std::string text = scoreText(score);
  const ImVec2 at{p.x + ImGui::GetStyle().FramePadding.x, p.y + (height - ImGui::GetFontSize()) / 2};
  list->PushClipRect(p, {p.x + width, p.y + height}, true);
  list->AddText(at, ImGui::GetColorU32(ImGuiCol_Text), text.c_str());
  list->PopClipRect();
  ImGui::Dummy({width, height});
  std::string help = tr(score.help.c_str());
  for (std::size_t i = parts; i < score.parts.size(); ++i)
    help += fmt::format("\n{}: {}", tr(score.parts[i].name), score.parts[i].value);
  tooltip(help.c_str());
}

float widthOf(const MatchPart& part) {
  return ImGui::CalcTextSize(tr(part.name)).x + ImGui::GetStyle().ItemInnerSpacing.x +
         ImGui::CalcTextSize(part.value.c_str()).x;
}

// How many of the parts stand side by side; in a low panel the picture is worth more than any.
std::size_t shownParts(const UiState& ui, const MatchScore& score, const ImVec2& room) {
  if (room.y < 200 * static_cast<float>(ui.scale)) return 0;
  float left = room.x;
  std::size_t count = 0;
  for (; count < score.parts.size(); ++count) {
    left -= widthOf(score.parts[count]);
    if (left < 0) break;
    left -= 2 * ImGui::GetStyle().ItemSpacing.x;
  }
  return count;
}

void scoreParts(const UiState& ui, const MatchScore& score, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const MatchPart& part = score.parts[i];
    if (i > 0) ImGui::SameLine(0, 2 * ImGui::GetStyle().ItemSpacing.x);
    ImGui::BeginGroup();
    ImGui::TextColored(ink::quiet(ui.theme), "%s", tr(part.name));
    ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
    ImGui::TextColored(part.good ? ImGui::GetStyleColorVec4(ImGuiCol_Text) : ink::bad(ui.theme), "%s",
                       part.value.c_str());
    ImGui::EndGroup();
    ImGui::PushID(part.name);
    tooltip(part.help);
    ImGui::PopID();
  }
}

void sizeAndRender(Editor& editor, UiState& ui) {
  constexpr int sizes[] = {0, 64, 128, 256, 512, 1024};
  const char* names[] = {tr("as the grid"), "64 px", "128 px", "256 px", "512 px", "1024 px"};
  int chosen = static_cast<int>(std::find(std::begin(sizes), std::end(sizes), editor.preview.size) -
                                std::begin(sizes));
  const float width = ImGui::GetContentRegionAvail().x;
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  ImGui::SetNextItemWidth(0.32f * width);
  if (ImGui::Combo("##size", &chosen, names, 6)) editor.preview.size = sizes[std::clamp(chosen, 0, 5)];
  tooltip("The longer side of these pictures.");
  ImGui::SameLine();
  if (fittedButton("Render image", 0.4f * width - gap)) perform(Action::renderImage, editor, ui);
  tooltip("A high-resolution picture, to zoom into and to save.");
  ImGui::SameLine();
  if (fittedButton(editor.preview.expanded ? "Smaller" : "Larger", 0.28f * width - gap))
    editor.preview.expanded = !editor.preview.expanded;
}

}  // namespace

void drawPreviewPanel(Editor& editor, UiState& ui, const MatchScore& score) {
  if (!beginPanel("preview", ui.layout.preview, true, false)) {
    ui.hoveredCell.reset();
    return;
  }
  int tab = static_cast<int>(editor.preview.tab);
  const bool reflects = isVisible(editor.session.level().optic);
  const char* seen = reflects ? "Reflection" : "Seen by the eye";
  if (segmentedControl("tabs", tab, {seen, "Original", "Difference", "Wipe"}, 4)) {
    editor.preview.tab = static_cast<PreviewTab>(tab);
  }
  const ImGuiStyle& style = ImGui::GetStyle();
  ImVec2 room = ImGui::GetContentRegionAvail();
  const std::size_t parts = shownParts(ui, score, room);
  std::optional<DifferenceLegend> legend;
  if (editor.preview.tab == PreviewTab::difference) legend.emplace(reflects, room.x);
  float below = 2 * ImGui::GetFrameHeight() + 3 * style.ItemSpacing.y + (legend ? legend->height() : 0);
  if (parts > 0) below += ImGui::GetTextLineHeight() + style.ItemSpacing.y;
  room.y = std::max(1.0f, room.y - below);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  drawImages(editor, ui, imageRect(editor.session.level().grid, at, room));
  ImGui::SetCursorScreenPos({at.x, at.y + room.y + style.ItemSpacing.y});
  if (legend) legend->draw();
  scoreBar(ui, score, parts);
  scoreParts(ui, score, parts);
  sizeAndRender(editor, ui);
  ImGui::End();
}

}  // namespace anamorph
