// anamorph levels: what is installed; with -o, the picture, sculpture and score of each.

#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/folder.h"
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

// The picture and the sculpture of a level.
std::vector<Output> outputsOf(const LevelEntry& entry, const LevelsOptions& options) {
  const std::string base = (std::filesystem::path(options.folder) / entry.name).string();
  std::vector<Output> outputs;
  outputs.emplace_back(base + ".png");
  outputs.emplace_back(base + ".obj");
  return outputs;
}

// Before the first is computed.
void checkAllOutputs(const std::vector<LevelEntry>& entries, const LevelsOptions& options, bool noClobber) {
  std::vector<std::filesystem::path> inputs;
  std::vector<Output> outputs;
  for (const LevelEntry& entry : entries) {
    inputs.push_back(entry.path);
    for (Output& output : outputsOf(entry, options)) outputs.push_back(std::move(output));
  }
  checkOutputs(inputs, outputs, noClobber);
}

// Renders one level into the folder and prints its line of the table.
void showLevel(const LevelEntry& entry, const LevelsOptions& options, const CommonOptions& common) {
  InputOptions inputOptions;
  inputOptions.file = entry.path.string();
  const std::vector<Output> outputs = outputsOf(entry, options);
  const Input input = loadInput(inputOptions, common, outputs);
  const LevelResult finished = finishInput(input, common);
  const Mesh& sculpture = finished.sculpture.sculpture->mesh;
  const MatchReport report = matchInput(finished, options.size, options.size, common).report;
  const ImageRequest request = makeImageRequest(input.level, options.size, options.size, common.threads);
  savePng(outputs[0].path(), drawInput(finished, PictureKind::reflection, request, nullptr, common));
  saveMesh(outputs[1].path(), sculpture);
  fmt::print("{:<14} {:>9} {:>9.5f} {:>9.3f} {:>9.5f} {:>7.4f} {:>7.4f}  {}\n", entry.name,
             sculpture.triangles.size(), report.silhouetteIou, report.p99Px, report.triangleAgreement,
             report.hiddenShare, report.missedShare, matchGradeName(gradeOf(report)));
  flushResults();
}

void levels(const LevelsOptions& options, const CommonOptions& common) {
  const std::vector<LevelEntry> entries = listLevels();
  if (options.folder.empty()) {
    for (const LevelEntry& entry : entries) {
      fmt::print("{:<14} {}\n", entry.name, entry.problem.empty() ? entry.title : entry.problem);
    }
    return;
  }
  makeFolder(options.folder);
  checkAllOutputs(entries, options, common.noClobber);
  fmt::print("{:<14} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7}  {}\n", "level", "triangles", "IoU", "p99 px",
             "agreement", "hidden", "missed", "match");
  std::size_t bad = 0;
  for (const LevelEntry& entry : entries) {
    try {
      showLevel(entry, options, common);
    } catch (const Error& error) {  // the others are shown all the same
      fmt::print(stderr, "{}\n", error.what());
      ++bad;
    }
  }
  sayMessage(common, "pictures and sculptures are in " + options.folder);
  if (bad > 0) throw Error(fmt::format("{} of {} levels have faults", bad, entries.size()));
}

}  // namespace

void addLevelsCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("levels", "List the installed levels; with -o, render and score them all");
  const auto options = std::make_shared<LevelsOptions>();
  CLI::Option* folder = command->add_option("-o,--output", options->folder,
                                            "Folder for a picture and a sculpture of every level");
  addNoClobber(*command, common);
  command->add_option("--size", options->size, "Width and height of the pictures (default 512)")
      ->needs(folder)
      ->check(numberIn(limits::renderedSize.level));
  addCommonOptions(*command, common);
  command->callback([options, &common] { levels(*options, common); });
}

}  // namespace anamorph
