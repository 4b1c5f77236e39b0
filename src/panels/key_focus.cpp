#include "panels/key_focus.h"

#include <algorithm>
#include <cstddef>

#include <imgui.h>
#include <imgui_internal.h>

#include "panels/keys.h"

namespace anamorph {
void moveKeyFocus(KeyFocus& focus, const std::vector<std::string>& reachable, int direction) {
  const auto places = static_cast<std::ptrdiff_t>(reachable.size()) + 1;  // the last one is the 3D view
  const auto now = std::find(reachable.begin(), reachable.end(), focus.window) - reachable.begin();
  const auto next = (now + direction + places) % places;
  if (next + 1 == places) return leaveKeyFocus(focus);
  focus = {reachable[static_cast<std::size_t>(next)], true};
}

void leaveKeyFocus(KeyFocus& focus) {
  focus.window.clear();
}

bool isForPanel(const KeyFocus& focus, int key, int modifiers) {
  if (focus.window.empty() || (modifiers & ~keys::shift) != 0) return false;
  return key != keys::escape && (key < keys::f1 || key > keys::f12);
}

void updateKeyFocus(KeyFocus& focus, const std::vector<std::string>& reachable, bool rests) {
  ImGuiIO& io = ImGui::GetIO();
  if (!focus.window.empty()) {
    const bool gone = std::find(reachable.begin(), reachable.end(), focus.window) == reachable.end();
    if (gone || ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1)) leaveKeyFocus(focus);
  }
  if (focus.window.empty() || rests) {
    if ((io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0) GImGui->NavDisableHighlight = true;
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
    focus.entered = !focus.window.empty();
    return;
  }
  io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
  ImGuiWindow* window = ImGui::FindWindowByName(focus.window.c_str());
  if (!window) return;
  if (focus.entered) {
    ImGui::FocusWindow(window);
    ImGui::NavInitWindow(window, true);
    focus.entered = false;
  }
  GImGui->NavDisableHighlight = false;
}

}  // namespace anamorph
