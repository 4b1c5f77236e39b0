#include "panels/windows.h"

#include <utility>

namespace anamorph {

std::vector<std::string> reachableWindows(const UiState& ui) {
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
  add(ui.progress.open, "###progress");
  add(ui.helpOpen, "###help");
  return names;
}

bool closeWindows(UiState& ui) {
  bool any = false;
  for (bool* open : {&ui.exporting.open, &ui.render.open, &ui.progress.open, &ui.helpOpen})
    any |= std::exchange(*open, false);
  return any;
}

}  // namespace anamorph
