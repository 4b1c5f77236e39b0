// Lights and sky.

#include <string>

#include <fmt/format.h>
#include <imgui.h>

#include "base/language.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

bool lightRows(Editor& editor, Level& level, int index) {
  PointLight& light = level.lights[index];
  bool changed = vectorRow("Position", light.position, {limits::coordinates, 0.02, "%.2f"});
  changed |= colorRow("Colour", light.color);
  changed |= sliderRow("Intensity", light.intensity, {limits::lightIntensity.panel, 0.01, "%.2f"});
  if (wideButton("Remove this light")) {
    level.lights.erase(level.lights.begin() + index);
    editor.selection = {};
    changed = true;
  }
  return changed;
}

}  // namespace

void drawLightProperties(Editor& editor, UiState& ui) {
  Level level = editor.session.level();
  bool changed = false;
  if (section(ui, "Lights")) {
    const int chosen = editor.selection.part == Part::light ? editor.selection.index : -1;
    for (int i = 0; i < static_cast<int>(level.lights.size()); ++i) {
      const std::string name = trFormat("Light {}", i + 1);
      const std::string label = fmt::format("{}###light{}", name, i);
      if (ImGui::Selectable(label.c_str(), i == chosen)) editor.selection = {Part::light, i};
    }
    if (wideButton("Add a light", "At most 8.", level.lights.size() < limits::mostOfferedLights)) {
      level.lights.push_back({});
      editor.selection = {Part::light, static_cast<int>(level.lights.size()) - 1};
      changed = true;
    } else if (chosen >= 0 && chosen < static_cast<int>(level.lights.size())) {
      changed |= lightRows(editor, level, chosen);
    }
    checkRow("Show the lights", editor.display.lightMarkers, "As small bright balls in the 3D view.");
  }
  if (section(ui, "Surroundings", false)) {
    changed |= colorRow("Sky above", level.background.top);
    changed |= colorRow("Sky below", level.background.bottom);
    changed |= checkRow("Ground", level.ground.visible);
    changed |= numberRow("Ground height", level.ground.height, {limits::coordinates, 0.02, "%.2f"});
  }
  if (changed) editor.session.change(std::move(level));
}

}  // namespace anamorph
