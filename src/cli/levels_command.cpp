// anamorph levels: what is installed; with -o, the picture, sculpture and score of each.

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/report.h"
#include "level/level_library.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

struct LevelsOptions {
  std::string folder;  // empty: only list
  int size = 512;
};

// Renders one level into the folder and prints its line of the table.
void showLevel(const LevelEntry& entry, const LevelsOptions& options, const CommonOptions& common) {
  InputOptions inputOptions;
  inputOptions.file = entry.path.string();
  const Input input = loadInput(inputOptions, common);
  const FinishedLevel finished = finishInput(input, common);
  const Mesh& sculpture = finished.sculpture.sculpture->mesh;
  const MatchReport report = matchLevel(finished, options.size, options.size, common.threads).report;
  const ImageRequest request = makeImageRequest(input.level, options.size, options.size, common.threads);
  const std::filesystem::path base = std::filesystem::path(options.folder) / entry.name;
  savePng(base.string() + ".png", *makePicture(finished, PictureKind::reflection, request));
  saveMesh(base.string() + ".obj", sculpture);
  fmt::print("{:<12} {:>9} {:>9.5f} {:>9.3f} {:>9.5f} {:>7.4f} {:>7.4f}  {}\n", entry.name,
             sculpture.triangles.size(), report.silhouetteIou, report.p99Px, report.triangleAgreement,
             report.hiddenShare, report.missedShare, matchGradeName(gradeOf(report)));
  std::fflush(stdout);
}

void levels(const LevelsOptions& options, const CommonOptions& common) {
  const std::vector<LevelEntry> entries = listLevels();
  if (options.folder.empty()) {
    for (const LevelEntry& entry : entries) {
      fmt::print("{:<12} {}\n", entry.name, entry.problem.empty() ? entry.title : entry.problem);
    }
    return;
  }
  std::error_code failure;
  std::filesystem::create_directories(options.folder, failure);
  if (failure) throw Error("cannot make the folder: " + failure.message(), options.folder);
  fmt::print("{:<12} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7}  {}\n", "level", "triangles", "IoU", "p99 px",
             "agreement", "hidden", "missed", "match");
  for (const LevelEntry& entry : entries) showLevel(entry, options, common);
  sayMessage(common, "pictures and sculptures are in " + options.folder);
}

}  // namespace

void addLevelsCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("levels", "List the installed levels; with -o, render and score them all");
  const auto options = std::make_shared<LevelsOptions>();
  command->add_option("-o,--output", options->folder, "Folder for a picture and a sculpture of every level");
  command->add_option("--size", options->size, "Width and height of the pictures (default 512)")
      ->check(CLI::Range(1, 8192));
  addCommonOptions(*command, common);
  command->callback([options, &common] { levels(*options, common); });
}

}  // namespace anamorph
