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

void item(Action action, Workspace& work, UiState& ui, bool enabled = true, bool checked = false) {
  for (const ActionText& text : actionTexts()) {
    if (text.action != action) continue;
    const std::string key = keyNameOf(action, ui.preferences.vrtKeys);
    if (ImGui::MenuItem(tr(text.name), key.c_str(), checked, enabled)) perform(action, work, ui);
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

void fileMenu(Workspace& work, UiState& ui) {
  item(Action::newLevel, work, ui);
  item(Action::open, work, ui);
  recentMenu(ui);
  item(Action::reload, work, ui, !work.session.path().empty());
  ImGui::Separator();
  item(Action::save, work, ui);
  item(Action::saveAs, work, ui);
  ImGui::Separator();
  item(Action::exportFiles, work, ui);
  item(Action::renderImage, work, ui);
  item(Action::screenshot, work, ui);
  ImGui::Separator();
  item(Action::quit, work, ui);
}

void editMenu(Workspace& work, UiState& ui) {
  item(Action::undo, work, ui, work.session.canUndo());
  item(Action::redo, work, ui, work.session.canRedo());
  item(Action::resetLevel, work, ui, work.session.modified());
  item(Action::copyLevel, work, ui);
  item(Action::pasteLevel, work, ui);
  ImGui::Separator();
  item(Action::moveMode, work, ui, true, work.gizmoMode == GizmoMode::move);
  item(Action::rotateMode, work, ui, true, work.gizmoMode == GizmoMode::rotate);
  item(Action::scaleMode, work, ui, true, work.gizmoMode == GizmoMode::scale);
  item(Action::toggleLocal, work, ui, true, work.gizmoLocal);
}

void viewMenu(Workspace& work, UiState& ui) {
  item(Action::lookThrough, work, ui, true, work.lookingThrough);
  ImGui::Separator();
  item(Action::frameSelection, work, ui);
  item(Action::frameAll, work, ui);
  item(Action::viewFront, work, ui);
  item(Action::viewRight, work, ui);
  item(Action::viewTop, work, ui);
  item(Action::toggleParallel, work, ui, true, work.pose.orthographic);
  ImGui::Separator();
  item(Action::pauseRays, work, ui, work.rays.animate, work.animationPaused);
  item(Action::rayStepForward, work, ui, work.rays.show);
  item(Action::rayStepBack, work, ui, work.rays.show);
  item(Action::hidePanels, work, ui, true, ui.panelsHidden);
  item(Action::nextPanel, work, ui, !ui.panelsHidden);
  item(Action::fullscreen, work, ui);
  item(Action::present, work, ui, true, ui.presenting);
}

void menus(Workspace& work, UiState& ui) {
  if (ImGui::BeginMenu(tr("File"))) {
    fileMenu(work, ui);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("Edit"))) {
    editMenu(work, ui);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("View"))) {
    viewMenu(work, ui);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("Level"))) {
    for (const LevelEntry& entry : ui.levels) {
      const bool open = isOpen(work, entry);
      if (ImGui::MenuItem(entry.title.empty() ? entry.name.c_str() : tr(entry.title.c_str()), nullptr,
                          open)) {
        ui.requests.open = entry.path;
      }
    }
    ImGui::Separator();
    item(Action::previousLevel, work, ui);
    item(Action::nextLevel, work, ui);
    ImGui::Separator();
    item(Action::previousStep, work, ui, !work.lesson.empty());
    item(Action::nextStep, work, ui, !work.lesson.empty());
    item(Action::showStep, work, ui, !work.lesson.empty());
    item(Action::progress, work, ui, true, ui.progressOpen);
    ImGui::EndMenu();
  }
  if (ImGui::BeginMenu(tr("Help"))) {
    item(Action::help, work, ui);
    item(Action::tour, work, ui);
    ImGui::EndMenu();
  }
}

void rightEnd(Workspace& work, UiState& ui) {
  const MatchScore score = matchScore(work.studio.products());
  const std::string text = scoreText(score);
  const ImGuiStyle& style = ImGui::GetStyle();
  const float undo = ImGui::CalcTextSize(tr("Undo")).x + 2 * style.FramePadding.x;
  const float redo = ImGui::CalcTextSize(tr("Redo")).x + 2 * style.FramePadding.x;
  const float width = ImGui::CalcTextSize(text.c_str()).x + undo + redo + 4 * style.ItemSpacing.x;
  const float x = ImGui::GetWindowWidth() - width - style.WindowPadding.x;
  if (x < ImGui::GetCursorPosX()) return;
  ImGui::SetCursorPosX(x);
  ImGui::BeginDisabled(!work.session.canUndo());
  if (ImGui::SmallButton(tr("Undo"))) perform(Action::undo, work, ui);
  ImGui::EndDisabled();
  ImGui::BeginDisabled(!work.session.canRedo());
  if (ImGui::SmallButton(tr("Redo"))) perform(Action::redo, work, ui);
  ImGui::EndDisabled();
  ImGui::TextColored(scoreColor(score, ui.preferences.theme), "%s", text.c_str());
  tooltip(score.help.c_str());
}

}  // namespace

void drawMenuBar(Workspace& work, UiState& ui) {
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
    menus(work, ui);
    ImGui::PopStyleVar();
    rightEnd(work, ui);
    ImGui::EndMenuBar();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace anamorph
