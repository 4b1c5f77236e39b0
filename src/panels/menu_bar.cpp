// The menu bar, with the match score at its right end.

#include <algorithm>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/actions.h"
#include "panels/highlight.h"
#include "panels/match_score.h"
#include "panels/panels.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void item(Action action, Editor& editor, UiState& ui) {
  const ActionRow& row = rowOf(action);
  const std::string key = keyName(keysOf(row, ui.preferences.vrtKeys).front());
  if (ImGui::MenuItem(tr(row.name), key.c_str(), row.ticked(editor, ui), row.enabled(editor, ui)))
    perform(action, editor, ui);
  tooltip(row.help);
}

void items(std::initializer_list<Action> actions, Editor& editor, UiState& ui) {
  for (const Action action : actions) item(action, editor, ui);
}

void recentMenu(UiState& ui) {
  if (!ImGui::BeginMenu(tr("Recent"), !ui.recentLevels.empty())) return;
  for (const std::filesystem::path& path : ui.recentLevels) {
    std::error_code ignored;
    const bool there = std::filesystem::exists(path, ignored);
    ImGui::PushID(path.c_str());
    if (ImGui::MenuItem(path.filename().c_str(), nullptr, false, there)) ui.requests.open = path;
    ImGui::PopID();
    tooltip(there ? path.c_str() : trFormat("{} is not there any more.", path.string()).c_str());
  }
  ImGui::EndMenu();
}

void fileMenu(Editor& editor, UiState& ui) {
  items({Action::newLevel, Action::open}, editor, ui);
  recentMenu(ui);
  item(Action::reload, editor, ui);
  ImGui::Separator();
  items({Action::save, Action::saveAs}, editor, ui);
  ImGui::Separator();
  items({Action::exportFiles, Action::renderImage, Action::screenshot}, editor, ui);
  ImGui::Separator();
  item(Action::quit, editor, ui);
}

void editMenu(Editor& editor, UiState& ui) {
  items({Action::undo, Action::redo, Action::resetLevel, Action::copyLevel, Action::copyLevelWithMesh,
         Action::pasteLevel},
        editor, ui);
  ImGui::Separator();
  items({Action::moveMode, Action::rotateMode, Action::scaleMode, Action::toggleLocal}, editor, ui);
  ImGui::Separator();
  item(Action::toggleFrozen, editor, ui);
}

void viewMenu(Editor& editor, UiState& ui) {
  item(Action::lookThrough, editor, ui);
  ImGui::Separator();
  items({Action::frameSelection, Action::frameAll, Action::viewFront, Action::viewRight, Action::viewTop,
         Action::toggleParallel},
        editor, ui);
  ImGui::Separator();
  items({Action::hideMirror, Action::originalAlone, Action::sculptureAlone, Action::mirrorAlone}, editor, ui);
  ImGui::Separator();
  items({Action::pauseRays, Action::rayStepForward, Action::rayStepBack, Action::hidePanels,
         Action::nextPanel, Action::fullscreen, Action::present},
        editor, ui);
}

void levelMenu(Editor& editor, UiState& ui) {
  for (const LevelEntry& entry : ui.levels) {
    const std::string title = inOneLine(entry.title.empty() ? entry.name : tr(entry.title));
    if (ImGui::MenuItem(title.c_str(), nullptr, isOpen(editor, entry))) ui.requests.open = entry.path;
  }
  ImGui::Separator();
  items({Action::previousLevel, Action::nextLevel}, editor, ui);
  ImGui::Separator();
  items({Action::previousStep, Action::nextStep, Action::restartStep, Action::pointAtStep, Action::playStep,
         Action::progress},
        editor, ui);
}

void helpMenu(Editor& editor, UiState& ui) {
  items({Action::help, Action::tour}, editor, ui);
}

void menus(Editor& editor, UiState& ui) {
  struct Menu {
    const char* name;
    void (*draw)(Editor&, UiState&);
  };
  constexpr Menu all[] = {
      {"File", fileMenu}, {"Edit", editMenu}, {"View", viewMenu}, {"Level", levelMenu}, {"Help", helpMenu}};
  for (const Menu& menu : all) {
    const bool open = ImGui::BeginMenu(tr(menu.name));
    highlightItem(menu.name);
    if (!open) continue;
    menu.draw(editor, ui);
    ImGui::EndMenu();
  }
}

void smallButton(Action action, Editor& editor, UiState& ui) {
  ImGui::BeginDisabled(!isEnabled(action, editor, ui));
  if (ImGui::SmallButton(tr(rowOf(action).name))) perform(action, editor, ui);
  ImGui::EndDisabled();
}

float widthOfSmallButton(Action action) {
  return ImGui::CalcTextSize(tr(rowOf(action).name)).x + 2 * ImGui::GetStyle().FramePadding.x +
         ImGui::GetStyle().ItemSpacing.x;
}

// The match with its word, and the buttons before it; in a narrow window what is worth most of that.
void rightEnd(Editor& editor, UiState& ui, const MatchScore& score) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float end = ImGui::GetWindowWidth() - style.WindowPadding.x - 2 * style.ItemSpacing.x;
  const float buttons = widthOfSmallButton(Action::undo) + widthOfSmallButton(Action::redo);
  struct Choice {
    bool buttons;
    std::string text;
  };
  const Choice choices[] = {{true, scoreText(score)}, {true, score.percent}, {false, score.percent}};
  for (const Choice& choice : choices) {
    const float width = ImGui::CalcTextSize(choice.text.c_str()).x + (choice.buttons ? buttons : 0);
    if (end - width < ImGui::GetCursorPosX()) continue;
    ImGui::SetCursorPosX(end - width);
    if (choice.buttons) {
      smallButton(Action::undo, editor, ui);
      smallButton(Action::redo, editor, ui);
    }
    ImGui::TextColored(scoreColor(score, ui.theme), "%s", choice.text.c_str());
    tooltip(score.help.c_str());
    return;
  }
}

}  // namespace

void drawMenuBar(Editor& editor, UiState& ui, const MatchScore& score) {
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
    rightEnd(editor, ui, score);
    ImGui::EndMenuBar();
  }
  ImGui::End();
  ImGui::PopStyleVar(3);
}

}  // namespace anamorph
