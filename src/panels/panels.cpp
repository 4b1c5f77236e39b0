#include "panels/panels.h"

#include <algorithm>
#include <filesystem>

#include <imgui.h>

#include "panels/dialogs.h"
#include "panels/export_window.h"
#include "panels/highlight.h"
#include "panels/key_focus.h"
#include "panels/progress_window.h"
#include "panels/render_window.h"
#include "panels/tour.h"
#include "panels/view_panel.h"
#include "panels/windows.h"

namespace anamorph {
namespace {

// A border between panels that can be dragged. `size` is at scale 1; `direction` is +1 where dragging right
// or down makes it larger.
void splitter(const UiState& ui, const char* id, const Rect& grip, bool vertical, double& size,
              double direction, double smallest, double largest) {
  if (grip.empty()) return;
  ImGui::SetNextWindowPos({grip.x, grip.y});
  ImGui::SetNextWindowSize({grip.width, grip.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin(id, nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoFocusOnAppearing);
  ImGui::InvisibleButton("grip", {std::max(1.0f, grip.width), std::max(1.0f, grip.height)});
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled({grip.x, grip.y}, {grip.x + grip.width, grip.y + grip.height},
                                              ImGui::GetColorU32(ImGuiCol_SeparatorHovered));
  }
  if (ImGui::IsItemActive()) {
    const ImVec2 delta = ImGui::GetIO().MouseDelta;
    size = std::clamp(size + direction * (vertical ? delta.x : delta.y) / ui.scale, smallest, largest);
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void drawSplitters(UiState& ui) {
  const Layout& l = ui.layout;
  const float t = 4 * static_cast<float>(ui.scale);
  Preferences& p = ui.preferences;
  if (!l.lesson.empty()) {
    splitter(ui, "##split-left",
             {l.lesson.x + l.lesson.width - t / 2, l.left.y, t, l.left.height + l.lesson.height}, true,
             p.leftWidth, 1, smallestLeft, 600);
  }
  if (!l.properties.empty()) {
    splitter(ui, "##split-right",
             {l.properties.x - t / 2, l.properties.y, t, l.properties.height + l.preview.height}, true,
             p.rightWidth, -1, smallestRight, 900);
  }
  if (!l.preview.empty() && !l.properties.empty()) {
    splitter(ui, "##split-preview", {l.preview.x, l.preview.y - t / 2, l.preview.width, t}, false,
             p.previewHeight, -1, 220, 1400);
  }
}

void drawWindows(Editor& editor, UiState& ui) {
  const std::filesystem::path& level = editor.session.path();
  drawRenderWindow(ui.render, ui.textures.render, level, ui.browser, ui.requests, ui);
  drawExportWindow(ui.exporting, level, ui.browser, ui.requests, ui);
  drawHelpWindow(editor, ui);
  drawProgressWindow(ui.progress, editor, ui.levels, ui);
  drawPresenter(editor, ui);
  drawTour(ui.tour, ui.preferences, ui.layout, ui.tabsArea, ui);
}

// A number that is dragged, typed or clicked is one step of the history. Esc while it is typed takes back all of it:
// the field itself would only write the digits that it had shown.
void finishChange(Editor& editor, const UiState& ui) {
  if (!editor.session.changing() || ui.mouse.gizmoDrag || editor.lesson.play || ImGui::IsAnyItemActive())
    return;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) {
    editor.session.cancelChange();
  } else {
    editor.session.finishChange();
  }
}

}  // namespace

void handleInput(Editor& editor, UiState& ui) {
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const Preferences& p = ui.preferences;
  ui.layout = makeLayout({.width = display.x,
                          .height = display.y,
                          .scale = static_cast<float>(ui.scale),
                          .leftWidth = static_cast<float>(p.leftWidth),
                          .rightWidth = static_cast<float>(p.rightWidth),
                          .previewHeight = static_cast<float>(p.previewHeight),
                          .panelsHidden = ui.panelsHidden,
                          .presenting = ui.presenting,
                          .previewExpanded = editor.preview.expanded,
                          .levels = static_cast<int>(ui.levels.size()),
                          .lessonRuns = !editor.lesson.empty(),
                          .levelsOpen = ui.levelsOpen,
                          .wordsHeight = presenterHeight(editor, ui)});
  updateKeyFocus(ui.keyFocus, reachableWindows(ui), isDialogOpen(ui));
  // How many frames a picture of the window takes differs from run to run: there it stands still.
  const double seconds = ui.headless ? 0 : static_cast<double>(ImGui::GetIO().DeltaTime);
  advanceHighlight(ui.highlight, editor.lesson, seconds);
  handleView(editor, ui);
}

void drawPanels(Editor& editor, UiState& ui) {
  const HighlightScope highlight(ui.highlight);
  const MatchScore score = matchScore(editor.updater.result());
  drawMenuBar(editor, ui, score);
  drawLevelPanel(editor, ui);
  drawLessonPanel(editor, ui);
  drawPropertiesPanel(editor, ui);
  drawPreviewPanel(editor, ui, score);
  drawStatusLine(editor, ui);
  drawSplitters(ui);
  drawWindows(editor, ui);
  drawDialogs(editor, ui);
  finishChange(editor, ui);
  drawView(editor, ui);
}

}  // namespace anamorph
