// anamorph [LEVEL]: the window.

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "app/commands.h"
#include "app/preferences.h"
#include "app/step_option.h"
#include "app/window.h"
#include "cli/input.h"
#include "geometry/mesh_files.h"
#include "level/languages.h"

namespace anamorph {

MoreCommands windowCommands() {
  return {{addOpenCommand, addScreenshotCommand, addBenchDragCommand}, "open"};
}

void addOpenCommand(CLI::App& app, CommonOptions&) {
  struct Options {
    std::string level = "0-perspective", model, theme, language, stateLog;
    double uiScale = 0;
    std::pair<int, int> size{1280, 800};
    std::optional<std::size_t> step;
    bool fullscreen = false, present = false, noTour = false;
  };
  CLI::App* command = app.add_subcommand("open", "Open the window (also without the word: anamorph LEVEL)");
  const auto options = std::make_shared<Options>();
  command->add_option("LEVEL", options->level,
                      "A level (a file, or the name of an installed one) or a thesis scene");
  command->add_option("MODEL", options->model,
                      "An OBJ, STL or PLY mesh that takes the place of the original");
  command->add_option("--theme", options->theme, "dark, light or projector")
      ->check(CLI::IsMember({"dark", "light", "projector"}));
  command
      ->add_option("--ui-scale", options->uiScale,
                   "Size of text and controls, 0.75 to 3 (default: as the screen says)")
      ->check(numberIn(limits::uiScale));
  addLanguageOption(*command, options->language, "Of the panels: en, nl, ... (default: as the system)");
  addSizeOption(*command, options->size);
  command->add_flag("--fullscreen", options->fullscreen, "Fill the screen");
  addStepOption(*command, options->step, "The step of the lesson to begin with, from 1 on");
  command->add_flag("--present", options->present,
                    "The step in large letters and a mark around the mouse, for an audience (F3)");
  command->add_flag("--no-tour", options->noTour, "Do not show newcomers around");
  command->add_option("--log-state", options->stateLog, "A file that gets a JSON line for every frame")
      ->group("");  // for tests and demonstrations: not in the help
  command->callback([options] {
    WindowOptions window;
    if (isModelFile(options->level) && options->model.empty()) {
      options->model = std::exchange(options->level, "1-plane");
    }
    window.model = options->model;
    for (const std::string& name : {options->level, options->model}) checkInput(name);
    if (!window.model.empty()) loadMesh(window.model);
    window.level = readLevelFile(levelNamed(options->level));  // an Error comes before a window does
    checkStep(options->step, window.level.loaded.lesson);
    if (!options->language.empty()) chooseLanguage(options->language);
    window.language = options->language;
    window.theme = findTheme(options->theme);
    if (options->uiScale > 0) window.uiScale = options->uiScale;
    window.fullscreen = options->fullscreen;
    window.step = options->step.value_or(0);
    window.present = options->present;
    window.tour = !options->noTour;
    window.width = options->size.first;
    window.height = options->size.second;
    window.stateLog = options->stateLog;
    runWindow(window);
  });
}

}  // namespace anamorph
