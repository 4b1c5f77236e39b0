// The 3D view, the words of the level, and the program itself: theme, scale, language.

#include <utility>

#include "edit/orbit.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void languageRow(UiState& ui) {
  std::vector<const char*> names{"As the system"};
  int chosen = 0;
  for (const LanguageChoice& language : ui.languages) {
    if (language.code == ui.preferences.language) chosen = static_cast<int>(names.size());
    names.push_back(language.name.c_str());
  }
  if (!choiceRow("Language", chosen, names)) return;
  ui.preferences.language = chosen == 0 ? "" : ui.languages[static_cast<std::size_t>(chosen - 1)].code;
}

void levelWords(Editor& editor) {
  Level level = editor.session.level();
  LevelText text = *level.text;
  bool changed = textFieldRow("Title", text.title, limits::mostTitleBytes);
  changed |= textFieldRow("Description", text.description, limits::mostTextBytes, 4,
                          "Shown when the level has no lesson.");
  if (!changed) return;
  level.text = std::move(text);
  editor.session.change(std::move(level));
}

}  // namespace

void drawViewProperties(Editor& editor, UiState& ui) {
  Preferences& preferences = ui.preferences;
  if (section(ui, "3D view")) {
    bool parallel = editor.pose.orthographic;
    if (checkRow("Parallel projection", parallel,
                 "Lines of sight side by side instead of from one eye. The key 5 does the same.")) {
      takeOverView(editor);
      editor.pose = togglePerspective(editor.pose);
    }
    if (!editor.lookingThrough &&
        sliderRow("Field of view", editor.pose.fovDegrees, {limits::viewFieldOfView.panel, 0.1, "%.1f°"})) {
      takeOverView(editor);
    }
    int alone = static_cast<int>(editor.display.alone);
    if (choiceRow("Show only", alone, {"Everything", "Original", "Sculpture", "Mirror"},
                  "One thing alone, without rays, RT camera and lights.")) {
      editor.display.alone = static_cast<ShownAlone>(alone);
    }
    bool hidden = !editor.display.mirror;
    if (checkRow("Hide the mirror", hidden, "What it shows is seen in the preview all the same."))
      editor.display.mirror = !hidden;
    checkRow("Legend", preferences.legend, "What the colours and line styles of the rays mean.");
  }
  if (section(ui, "Title and description", false)) levelWords(editor);
  if (section(ui, "Program")) {
    int theme = static_cast<int>(preferences.theme);
    if (choiceRow("Theme", theme, {"Dark", "Light", "Projector"},
                  "Projector: white, with large text and thick lines.")) {
      preferences.theme = static_cast<Theme>(theme);
    }
    languageRow(ui);
    int automatic = preferences.uiScale > 0 ? 1 : 0;
    if (choiceRow("Size", automatic, {"As the screen says", "My own"})) {
      preferences.uiScale = automatic == 0 ? 0 : ui.scale;
    }
    if (preferences.uiScale > 0) {
      int percent = static_cast<int>(100 * preferences.uiScale + 0.5);
      const int before = percent / 25;
      if (integerRow("Percent", percent, {100 * limits::uiScale.min, 100 * limits::uiScale.max},
                     "In steps of 25.") &&
          percent / 25 != before) {
        preferences.uiScale = 0.25 * (percent / 25);
      }
    }
    checkRow("T R S to move, rotate, scale", preferences.vrtKeys,
             "As in Virtual Ray Tracer, instead of W E R.");
  }
}

}  // namespace anamorph
