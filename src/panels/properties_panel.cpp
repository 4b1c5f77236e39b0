// The right panel: the properties of what is selected (panels/property_tabs.h).

#include <array>

#include <imgui.h>

#include "panels/panels.h"
#include "panels/property_tabs.h"
#include "panels/widgets.h"

namespace anamorph {
void drawPropertiesPanel(Editor& editor, UiState& ui) {
  followSelection(ui.tabs, editor.selection);
  if (!beginPanel("properties", ui.layout.properties)) return;
  int tab = static_cast<int>(ui.tabs.open);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool reflects = isVisible(editor.session.level().optic);
  const char* optic = reflects ? "Mirror" : "Canvas";
  if (segmentedControl("tabs", tab, {"Eye", "Original", optic, "Sculpture", "Lights", "Rays", "View"}, 4)) {
    openTab(ui.tabs, editor.selection, static_cast<PropertyTab>(tab));
  }
  ui.tabsArea = {low.x, low.y, ImGui::GetContentRegionAvail().x, ImGui::GetCursorScreenPos().y - low.y};
  using Draw = void (*)(Editor&, UiState&);
  constexpr std::array<Draw, 7> tabs{drawEyeProperties,       drawOriginalProperties, drawMirrorProperties,
                                     drawSculptureProperties, drawLightProperties,    drawRayProperties,
                                     drawViewProperties};
  ImGui::PushID(tab);  // every tab has its own place to be scrolled to
  ImGui::BeginChild("rows", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  tabs[static_cast<std::size_t>(tab)](editor, ui);
  ImGui::EndChild();
  ImGui::PopID();
  ImGui::End();
}

}  // namespace anamorph
