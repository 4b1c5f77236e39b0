#include "panels/dialog.h"

#include <algorithm>

#include <imgui.h>
#include <imgui_internal.h>

#include "base/language.h"
#include "panels/style.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

float buttonWidth(const char* name) {
  return std::max(5 * ImGui::GetFontSize(),
                  ImGui::CalcTextSize(tr(name)).x + 3 * ImGui::GetStyle().FramePadding.x);
}

}  // namespace

bool beginDialog(const Look& look, const char* title, float width, float height) {
  const std::string name = label(title);
  if (!ImGui::IsPopupOpen(name.c_str())) ImGui::OpenPopup(name.c_str());
  const ImVec2 display = ImGui::GetIO().DisplaySize;
  const float s = static_cast<float>(look.scale);
  ImGui::SetNextWindowPos({display.x / 2, display.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(width * s, 0.97f * display.x), std::min(height * s, 0.97f * display.y)});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 8 * s);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12 * s, 10 * s});
  const bool shown = ImGui::BeginPopupModal(name.c_str(), nullptr,
                                            ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                                ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleVar(2);
  if (shown) {
    // Windows that appear while it is open would cover it; only its own lists may.
    if (ImGui::IsWindowFocused(ImGuiFocusedFlags_ChildWindows | ImGuiFocusedFlags_NoPopupHierarchy)) {
      ImGui::BringWindowToDisplayFront(ImGui::GetCurrentWindow());
    }
    const FontScope strong(look.fonts.strong);
    ImGui::TextUnformatted(tr(title));
  }
  return shown;
}

void endDialog() {
  ImGui::EndPopup();
}

float dialogButtonsWidth(std::initializer_list<const char*> names) {
  float total = -ImGui::GetStyle().ItemSpacing.x;
  for (const char* name : names) total += buttonWidth(name) + ImGui::GetStyle().ItemSpacing.x;
  return total;
}

int dialogButtons(std::initializer_list<const char*> names, std::initializer_list<bool> enabled) {
  const float total = dialogButtonsWidth(names);
  const float room = ImGui::GetContentRegionAvail().x;
  const bool stacked = total > room;
  if (!stacked) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - total);
  int pressed = -1;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0 && !stacked) ImGui::SameLine();
    const char* name = names.begin()[i];
    if (i == 0) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_HeaderActive));
    ImGui::BeginDisabled(i < enabled.size() && !enabled.begin()[i]);
    if (ImGui::Button(label(name).c_str(), {stacked ? room : buttonWidth(name), 0}))
      pressed = static_cast<int>(i);
    ImGui::EndDisabled();
    if (i == 0) ImGui::PopStyleColor();
  }
  return pressed;
}

}  // namespace anamorph
