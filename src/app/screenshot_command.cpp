// anamorph screenshot: one settled frame of the window, without a window.

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "app/commands.h"
#include "app/headless_gui.h"
#include "app/preferences.h"
#include "app/shot.h"
#include "app/step_option.h"
#include "base/error.h"
#include "base/file.h"
#include "cli/input.h"
#include "cli/usage_error.h"
#include "edit/lesson_run.h"
#include "level/languages.h"
#include "panels/actions.h"
#include "panels/file_flow.h"
#include "panels/lesson_text.h"
#include "panels/style.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

struct ScreenshotOptions {
  std::string level, model, output, theme = "dark", language = "en", select, pixel, tab, modelUp;
  std::pair<int, int> size{1280, 800};
  double uiScale = 1;
  std::optional<double> morph;
  std::optional<std::size_t> step;
  int tour = 0;
  bool present = false, help = false, exporting = false, progress = false, doIt = false;
  bool noPanels = false, transparent = false, lookThrough = false;
  std::optional<std::uint32_t> vertex;
};

// "X,Y" to a cell of the pixel grid.
GridCell parseCell(const std::string& text, const PixelGrid& grid) {
  GridCell cell;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%d,%d%c", &cell.column, &cell.row, &rest) != 2 || cell.column < 0 ||
      cell.row < 0 || cell.column >= grid.columns || cell.row >= grid.rows) {
    throw UsageError(fmt::format("--pixel: expected COLUMN,ROW within the pixel grid of {} x {}, got {}",
                                 grid.columns, grid.rows, text));
  }
  return cell;
}

void pickVertex(Editor& editor, std::uint32_t vertex) {
  const LevelResult& result = editor.updater.result();
  if (!result.original.mesh) return;
  const Mesh& mesh = *result.original.mesh;
  pickPoint(editor, pickedVertex(mesh, vertex));
  if (!editor.point) {
    throw UsageError(fmt::format("--select-vertex: expected one of the original's vertices, 0 to {}, got {}",
                                 mesh.positions.size() - 1, vertex));
  }
  editor.selection = {Part::sculpture, 0};
}

void arrange(Editor& editor, UiState& ui, const ScreenshotOptions& options) {
  static const std::map<std::string, Part> parts{{"eye", Part::eye},
                                                 {"original", Part::original},
                                                 {"mirror", Part::mirror},
                                                 {"sculpture", Part::sculpture}};
  advanceLesson(editor);
  if (options.step) openStep(editor, *options.step - 1);
  if (!options.select.empty()) editor.selection = {parts.at(options.select), 0};
  const auto tab = std::find(previewTabs.begin(), previewTabs.end(), options.tab);
  if (tab != previewTabs.end()) editor.preview.tab = static_cast<PreviewTab>(tab - previewTabs.begin());
  if (!options.pixel.empty()) pickCell(editor, parseCell(options.pixel, editor.session.level().grid));
  if (options.morph) editor.display.morph = *options.morph;
  ui.panelsHidden = options.noPanels;
  if (options.lookThrough) toggleLookThrough(editor);
  if (options.present) perform(Action::present, editor, ui);
  if (options.help) perform(Action::help, editor, ui);
  if (options.exporting) perform(Action::exportFiles, editor, ui);
  if (options.progress) perform(Action::progress, editor, ui);
  if (options.tour > 0) ui.tour.card = options.tour - 1;
}

// What comes from standard input is read once, into a file that the window can read again.
class Model {
 public:
  Model(const std::string& name, const CommonOptions& common) : path_(name) {
    if (name.empty()) return;
    if (isStandardInput(name)) {
      const FileBytes bytes = readStandardInput(common.meshLimits().maxBytes, MeshLimits::bytesHelp);
      path_ = folder_.emplace().file(standardInputName);
      writeFile(path_, bytes.view());
    }
    sayWarnings(common, loadMesh(path_, common.meshLimits()).warnings);  // an Error comes before the work
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::optional<ScratchFolder> folder_;
  std::filesystem::path path_;
};

// `modelUp`: as of all commands, z unless it is said.
void takeModel(HeadlessGui& headless, const std::filesystem::path& model, const std::string& modelUp) {
  Editor& editor = headless.gui().editor();
  importOriginal(editor, model,
                 modelUp == "auto" ? std::nullopt : findModelUp(modelUp.empty() ? "z" : modelUp));
  while (editor.job.busy()) headless.frame();
}

void screenshot(const ScreenshotOptions& options, const CommonOptions& common) {
  Output output = pictureOutput(options.output, common);
  checkInputs(options.level, options.model);
  auto [path, loaded] = readLevelInput(options.level, common.meshLimits());
  checkStep(options.step, loaded.lesson);
  const std::string& read = isStandardInput(options.level) ? options.level : path;
  checkOutputs(filesRead(read, loaded.level, options.model), {&output, 1}, common.noClobber);
  sayWarnings(common, loaded.warnings);
  const Model model(options.model, common);
  const HeadlessContext context;
  Preferences preferences;
  preferences.theme = findTheme(options.theme).value_or(Theme::dark);
  preferences.uiScale = options.uiScale;
  preferences.language = options.language;
  chooseLanguage(options.language);
  HeadlessGui headless(options.size.first, options.size.second, preferences, common.threads);
  Gui& gui = headless.gui();
  gui.open(LevelFile{path, std::move(loaded), timeOf(path)});
  if (!options.model.empty()) {
    takeModel(headless, model.path(), options.modelUp);
  } else if (!options.modelUp.empty()) {
    Session& session = gui.editor().session;
    session.edit(applyModelUp(session.level(), options.modelUp, session.path(), common));
  }
  gui.setTransparent(options.transparent);
  gui.ui().bare = options.transparent && options.noPanels;
  arrange(gui.editor(), gui.ui(), options);
  headless.settle();
  if (options.doIt) {
    doStep(gui.editor(), gui.ui());
    headless.settle();
  }
  if (options.vertex) {
    pickVertex(gui.editor(), *options.vertex);
    headless.settle();
  }
  if (const double fits = gui.ui().scale / themeScale(preferences.theme); fits < options.uiScale - 1e-6)
    sayMessage(common, fmt::format("--ui-scale {:g}: {} x {} pixels have room for all panels at {:.4g} only",
                                   options.uiScale, options.size.first, options.size.second, fits));
  if (const auto& problem = gui.editor().updater.result().problem) sayMessage(common, *problem);
  Bitmap bitmap = headless.readBack();
  if (options.transparent) divideByAlpha(bitmap);
  sayWarnings(common, savePng(output.path(), options.transparent ? bitmap : withoutAlpha(bitmap)));
  output.deliver();
  sayPicture(common, output, bitmap.width, bitmap.height, "window");
}

}  // namespace

void addScreenshotCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("screenshot", "Draw what the window shows, without a display, as PNG");
  const auto options = std::make_shared<ScreenshotOptions>();
  command
      ->add_option(
          "FILE", options->level,
          "A level (a file, the name of an installed one, or - for standard input) or a thesis scene")
      ->required();
  command->add_option("MODEL", options->model,
                      "An OBJ, STL or PLY mesh, or -, that takes the place of the original");
  command->add_option("-o,--output", options->output, "The PNG file to write; - for standard output")
      ->required();
  addNoClobber(*command, common);
  addSizeOption(*command, options->size);
  command->add_option("--ui-scale", options->uiScale, "Size of text and controls, 0.75 to 3 (default 1)")
      ->check(numberIn(limits::uiScale));
  command->add_option("--theme", options->theme, "dark, light or projector (default dark)")
      ->check(CLI::IsMember({"dark", "light", "projector"}));
  addLanguageOption(*command, options->language, "Of the panels: en, nl, ... (default en)");
  command->add_flag("--no-panels", options->noPanels, "Only the 3D view");
  command->add_flag("--transparent", options->transparent, "No background and no ground: transparent there");
  command->add_flag("--look-through", options->lookThrough, "Seen through the RT camera");
  command->add_option("--select", options->select, "eye, original, mirror or sculpture")
      ->check(CLI::IsMember({"eye", "original", "mirror", "sculpture"}));
  command->add_option("--pixel", options->pixel,
                      "COLUMN,ROW of the pixel grid whose rays are shown, from 0,0 on top");
  command->add_option("--select-vertex", options->vertex,
                      "The original's vertex whose construction is shown");
  command->add_option("--preview", options->tab, "reflection, original, difference or wipe")
      ->check(CLI::IsMember(std::vector<std::string>(previewTabs.begin(), previewTabs.end())));
  addStepOption(*command, options->step, "The step of the lesson that is open, from 1 on");
  command->add_flag("--do-it,--show-me", options->doIt, "After the move that Do it makes of the step");
  command->add_flag("--present", options->present, "With the step in large letters, as for an audience");
  command->add_flag("--help-window", options->help, "With the help window");
  command->add_flag("--export-window", options->exporting, "With the export window");
  command->add_flag("--progress-window", options->progress, "With points and badges");
  command->add_option("--tour", options->tour, fmt::format("With a card of the tour, 1 to {}", tourCards))
      ->check(numberIn({1, tourCards}));
  command->add_option("--morph", options->morph, "0: the original, 1: the sculpture, between: on the way")
      ->check(numberIn(limits::fractions));
  addModelUpOption(*command, options->modelUp);
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { screenshot(*options, common); });
}

}  // namespace anamorph
