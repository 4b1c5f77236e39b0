// The right panel: the properties of what is selected. Choosing a tab selects its thing, selecting a thing in
// the 3D view chooses its tab.

#include <array>

#include <imgui.h>

#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

PropertyTab tabOf(const Selection& selection, PropertyTab otherwise) {
  switch (selection.part) {
    case Part::eye:
    case Part::aim:
      return PropertyTab::eye;
    case Part::original:
      return PropertyTab::original;
    case Part::mirror:
      return PropertyTab::mirror;
    case Part::sculpture:
      return PropertyTab::sculpture;
    case Part::light:
      return PropertyTab::lights;
    case Part::none:
      break;
  }
  return otherwise;
}

Selection selectionOf(PropertyTab tab, const Selection& current) {
  if (tabOf(current, PropertyTab::rays) == tab) return current;
  switch (tab) {
    case PropertyTab::eye:
      return {Part::eye, 0};
    case PropertyTab::original:
      return {Part::original, 0};
    case PropertyTab::mirror:
      return {Part::mirror, 0};
    case PropertyTab::sculpture:
      return {Part::sculpture, 0};
    default:
      return current;
  }
}

}  // namespace

void openTab(Editor& editor, UiState& ui, PropertyTab tab) {
  ui.tab = tab;
  editor.selection = ui.tabSelection = selectionOf(tab, editor.selection);
}

void drawPropertiesPanel(Editor& editor, UiState& ui) {
  if (!(ui.tabSelection == editor.selection)) {
    ui.tab = tabOf(editor.selection, ui.tab);
    ui.tabSelection = editor.selection;
  }
  if (!beginPanel("properties", ui.layout.properties)) return;
  int tab = static_cast<int>(ui.tab);
  const bool reflects = isVisible(editor.session.level().optic);
  const char* optic = reflects ? "Mirror" : "Canvas";
  if (segmentedControl("tabs", tab, {"Eye", "Original", optic, "Sculpture", "Lights", "Rays", "View"}, 4)) {
    openTab(editor, ui, static_cast<PropertyTab>(tab));
  }
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
