#include "panels/key_focus.h"

#include <algorithm>
#include <vector>

#include <imgui.h>
#include <imgui_internal.h>

#include "panels/actions.h"
#include "panels/dialog.h"

namespace anamorph {
namespace {

// The windows of Dear ImGui that can have the keyboard now, in the order of F6.
std::vector<std::string> reachable(const UiState& ui) {
  std::vector<std::string> names;
  const auto add = [&](bool shown, const char* name) {
    if (shown) names.emplace_back(name);
  };
  add(!ui.layout.left.empty(), "levels");
  add(!ui.layout.lesson.empty(), "lesson");
  add(!ui.layout.properties.empty(), "properties");
  add(!ui.layout.preview.empty(), "preview");
  add(ui.exporting.open, "###export");
  add(ui.render.open, "###render");
  add(ui.progressOpen, "###progress");
  add(ui.helpOpen, "###help");
  return names;
}

}  // namespace

void moveKeyFocus(UiState& ui, int direction) {
  const std::vector<std::string> names = reachable(ui);
  const auto places = static_cast<std::ptrdiff_t>(names.size()) + 1;  // the last one is the 3D view
  const auto now = std::find(names.begin(), names.end(), ui.keyPanel) - names.begin();
  const auto next = (now + direction + places) % places;
  if (next + 1 == places) return leaveKeyFocus(ui);
  ui.keyPanel = names[static_cast<std::size_t>(next)];
  ui.keyPanelEntered = true;
}

void leaveKeyFocus(UiState& ui) {
  ui.keyPanel.clear();
}

bool isForPanel(const UiState& ui, int key, int modifiers) {
  if (ui.keyPanel.empty() || (modifiers & ~keys::shift) != 0) return false;
  return key != keys::escape && (key < keys::f1 || key > keys::f12);
}

void updateKeyFocus(UiState& ui) {
  ImGuiIO& io = ImGui::GetIO();
  if (!ui.keyPanel.empty()) {
    const std::vector<std::string> names = reachable(ui);
    const bool gone = std::find(names.begin(), names.end(), ui.keyPanel) == names.end();
    if (gone || ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1)) leaveKeyFocus(ui);
  }
  // A dialog has keys of its own, and gives them back when it closes.
  const bool rests = ui.keyPanel.empty() || isDialogOpen(ui);
  if (rests) {
    if ((io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0) GImGui->NavDisableHighlight = true;
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    ui.keyPanelEntered = !ui.keyPanel.empty();
    return;
  }
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  ImGuiWindow* window = ImGui::FindWindowByName(ui.keyPanel.c_str());
  if (!window) return;
  if (ui.keyPanelEntered) {
    ImGui::FocusWindow(window);
    ImGui::NavInitWindow(window, true);
    ui.keyPanelEntered = false;
  }
  GImGui->NavDisableHighlight = false;
}

}  // namespace anamorph
