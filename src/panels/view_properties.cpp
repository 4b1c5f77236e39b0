// The 3D view, the words of the level, and the program itself: theme, scale, language.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/language.h"
#include "edit/orbit.h"
#include "panels/panels.h"
#include "panels/widgets.h"
#include "panels/wrapped_field.h"

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

// A list: a slider would move away under the mouse while it changes the size of everything.
void sizeRow(Preferences& preferences) {
  std::vector<double> sizes{0};
  for (double size = limits::uiScale.min; size <= limits::uiScale.max; size += 0.25) sizes.push_back(size);
  const auto own = std::lower_bound(sizes.begin(), sizes.end(), preferences.uiScale);
  if (own == sizes.end() || *own != preferences.uiScale) sizes.insert(own, preferences.uiScale);
  std::vector<std::string> texts;
  for (const double size : sizes) texts.push_back(shownFormat("{:.0f} %", 100 * size));
  texts.front() = tr("As the screen says");
  std::vector<const char*> names;
  for (const std::string& text : texts) names.push_back(text.c_str());
  int chosen = static_cast<int>(std::find(sizes.begin(), sizes.end(), preferences.uiScale) - sizes.begin());
  if (choiceRow("Size", chosen, names, "Of text and controls; no larger than leaves room for all panels."))
    preferences.uiScale = sizes[static_cast<std::size_t>(chosen)];
}

void levelWords(Editor& editor) {
  Level level = editor.session.level();
  LevelText text = *level.text;
  // What is read, also in another language, is what is edited.
  const auto edit = [](std::string& english, const auto& row) {
    std::string shown = tr(english);
    if (!row(shown)) return false;
    english = std::move(shown);
    return true;
  };
  bool changed = edit(
      text.title, [](std::string& title) { return textFieldRow("Title", title, limits::mostTitleBytes); });
  changed |= edit(text.description, [](std::string& description) {
    return wrappedFieldRow("Description", description, limits::mostTextBytes, 4,
                           "Shown when the level has no lesson.");
  });
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
    sizeRow(preferences);
    checkRow("T R S to move, rotate, scale", preferences.vrtKeys,
             "As in Virtual Ray Tracer, instead of W E R.");
  }
}

}  // namespace anamorph
