// The menu bar, with the match score at its right end.

#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/match_score.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void item(Action action, Editor& editor, UiState& ui, bool enabled = true, bool checked = false) {
  for (const ActionText& text : actionTexts()) {
    if (text.action != action) continue;
    const std::string key = keyNameOf(action, ui.preferences.vrtKeys);
    if (ImGui::MenuItem(tr(text.name), key.c_str(), checked, enabled)) perform(action, editor, ui);
    tooltip(text.help);
  }
}

void recentMenu(UiState& ui) {
  if (!ImGui::BeginMenu(tr("Recent"), !ui.recentLevels.empty())) return;
  for (const std::filesystem::path& path : ui.recentLevels) {
    std::error_code ignored;
    const bool there = std::filesystem::exists(path, ignored);
    ImGui::PushID(path.c_str());
    if (ImGui::MenuItem(path.filename().c_str(), nullptr, false, there)) ui.requests.open = path;
    ImGui::PopID();
    tooltip(there ? path.c_str()
                  : fmt::format(fmt::runtime(tr("{} is not there any more.")), path.string()).c_str());
  }
  ImGui::EndMenu();
}

void fileMenu(Editor& editor, UiState& ui) {
  item(Action::newLevel, editor, ui);
  item(Action::open, editor, ui);
  recentMenu(ui);
  item(Action::reload, editor, ui, !editor.session.path().empty());
  ImGui::Separator();
  item(Action::save, editor, ui);
  item(Action::saveAs, editor, ui);
  ImGui::Separator();
  item(Action::exportFiles, editor, ui);
  item(Action::renderImage, editor, ui);
  item(Action::screenshot, editor, ui);
  ImGui::Separator();
  item(Action::quit, editor, ui);
}

void editMenu(Editor& editor, UiState& ui) {
  item(Action::undo, editor, ui, editor.session.canUndo());
  item(Action::redo, editor, ui, editor.session.canRedo());
  item(Action::resetLevel, editor, ui, editor.session.modified());
  item(Action::copyLevel, editor, ui);
  item(Action::pasteLevel, editor, ui);
  ImGui::Separator();
  item(Action::moveMode, editor, ui, true, editor.gizmoMode == GizmoMode::move);
  item(Action::rotateMode, editor, ui, true, editor.gizmoMode == GizmoMode::rotate);
  item(Action::scaleMode, editor, ui, true, editor.gizmoMode == GizmoMode::scale);
  item(Action::toggleLocal, editor, ui, true, editor.gizmoLocal);
}

void viewMenu(Editor& editor, UiState& ui) {
  item(Action::lookThrough, editor, ui, true, editor.lookingThrough);
  ImGui::Separator();
  item(Action::frameSelection, editor, ui);
  item(Action::frameAll, editor, ui);
  item(Action::viewFront, editor, ui);
  item(Action::viewRight, editor, ui);
  item(Action::viewTop, editor, ui);
  item(Action::toggleParallel, editor, ui, true, editor.pose.orthographic);
  ImGui::Separator();
  item(Action::pauseRays, editor, ui, editor.rays.animate, editor.animationPaused);
  item(Action::rayStepForward, editor, ui, editor.rays.show);
  item(Action::rayStepBack, editor, ui, editor.rays.show);
  item(Action::hidePanels, editor, ui, true, ui.panelsHidden);
  item(Action::nextPanel, editor, ui, !ui.panelsHidden);
  item(Action::fullscreen, editor, ui);
  item(Action::present, editor, ui, true, ui.presenting);
}

void menus(Editor& editor, UiState& ui) {
  if (ImGui::BeginMenu(tr("File"))) {
    fileMenu(editor, ui);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("Edit"))) {
    editMenu(editor, ui);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("View"))) {
    viewMenu(editor, ui);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("Level"))) {
    for (const LevelEntry& entry : ui.levels) {
      const bool open = isOpen(editor, entry);
      if (ImGui::MenuItem(entry.title.empty() ? entry.name.c_str() : tr(entry.title.c_str()), nullptr,
                          open)) {
        ui.requests.open = entry.path;
      }
    }
    ImGui::Separator();
    item(Action::previousLevel, editor, ui);
    item(Action::nextLevel, editor, ui);
    ImGui::Separator();
    item(Action::previousStep, editor, ui, !editor.lesson.empty());
    item(Action::nextStep, editor, ui, !editor.lesson.empty());
    item(Action::showStep, editor, ui, !editor.lesson.empty());
    item(Action::progress, editor, ui, true, ui.progressOpen);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("Help"))) {
    item(Action::help, editor, ui);
    item(Action::tour, editor, ui);
    ImGui::EndMenu();
  }
}

void rightEnd(Editor& editor, UiState& ui) {
  const MatchScore score = matchScore(editor.updater.result());
  const std::string text = scoreText(score);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float undo = ImGui::CalcTextSize(tr("Undo")).x + 2 * style.FramePadding.x;
  const float redo = ImGui::CalcTextSize(tr("Redo")).x + 2 * style.FramePadding.x;
  const float width = ImGui::CalcTextSize(text.c_str()).x + undo + redo + 4 * style.ItemSpacing.x;
  const float x = ImGui::GetWindowWidth() - width - style.WindowPadding.x;
  if (x < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(x);
  ImGui::BeginDisabled(!editor.session.canUndo());
  if (ImGui::SmallButton(tr("Undo"))) perform(Action::undo, editor, ui);
  ImGui::EndDisabled();
  ImGui::BeginDisabled(!editor.session.canRedo());
  if (ImGui::SmallButton(tr("Redo"))) perform(Action::redo, editor, ui);
  ImGui::EndDisabled();
  ImGui::TextColored(scoreColor(score, ui.preferences.theme), "%s", text.c_str());
  tooltip(score.help.c_str());
}

}  // namespace

void drawMenuBar(Editor& editor, UiState& ui) {
  const Rect& rect = ui.layout.menu;
  if (rect.empty()) return;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding;
  ImGui::SetNextWindowPos({rect.x, rect.y});
  ImGui::SetNextWindowSize({rect.width, rect.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ImGui::GetStyle().WindowPadding.x, 0});
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x,
                                                   std::max(1.0f, (rect.height - ImGui::GetFontSize()) / 2)});
  ImGui::Begin("menu", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoBringToFrontOnFocus);
  if (ImGui::BeginMenuBar()) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);  // of the menus that open, not of the bar
    menus(editor, ui);
    ImGui::PopStyleVar();
    rightEnd(editor, ui);
    ImGui::EndMenuBar();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace anamorph
