// anamorph levels: what is installed; with -o, the picture, sculpture and score of each.

#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "base/error.h"
#include "base/folder.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/print.h"
#include "cli/report.h"
#include "level/level_library.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

struct LevelsOptions {
  std::string folder;  // empty: only list
  std::pair<int, int> size{512, 512};
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

// What is said of a level without looking into it.
JsonObject entryJson(const LevelEntry& entry) {
  JsonObject json;
  json.add("name", entry.name).add("path", entry.path.string());
  if (!entry.problem.empty()) return json.add("problem", entry.problem);
  return json.add("title", entry.title).add("steps", entry.lesson.steps.size());
}

// Renders one level into the folder, and prints its line of the table or returns the same as JSON.
JsonValue showLevel(const LevelEntry& entry, const LevelsOptions& options, const CommonOptions& common) {
  InputOptions inputOptions;
  inputOptions.file = entry.path.string();
  const std::vector<Output> outputs = outputsOf(entry, options);
  const Input input = loadInput(inputOptions, common, outputs);
  const LevelResult finished = finishInput(input, common);
  const Mesh& sculpture = finished.sculpture.sculpture->mesh;
  const auto [width, height] = options.size;
  const MatchReport report = matchInput(finished, width, height, common).report;
  const ImageRequest request = makeImageRequest(input.level, width, height, common.threads);
  const Image image = drawInput(finished, PictureKind::reflection, request, nullptr, common);
  sayWarnings(common, savePng(outputs[0].path(), image));
  sayWarnings(common, saveMesh(outputs[1].path(), sculpture));
  if (common.json) {
    return entryJson(entry)
        .add("picture", outputs[0].name())
        .add("sculpture", outputs[1].name())
        .add("triangles", sculpture.triangles.size())
        .add("match", matchJson(report, finished.sculpture.sculpture->originalStatus))
        .value();
  }
  printLine(stdout, fmt::format("{:<14} {:>9} {:>9.5f} {:>9.3f} {:>9.5f} {:>7.4f} {:>7.4f}  {}", entry.name,
                                sculpture.triangles.size(), report.silhouetteIou, report.p99Px,
                                report.triangleAgreement, report.hiddenShare, report.missedShare,
                                matchGradeName(gradeOf(report))));
  flushResults();
  return {};
}

void listAll(const std::vector<LevelEntry>& entries, const CommonOptions& common) {
  JsonValue list = emptyList();
  const char* group = "";
  for (const LevelEntry& entry : entries) {
    if (!common.json && std::strcmp(group, entry.group) != 0) {
      if (*group) printLine(stdout, "");
      printLine(stdout, fmt::format("{}:", entry.group));
      group = entry.group;
    }
    const std::string& text = entry.problem.empty() ? entry.title : entry.problem;
    list.items.push_back(entryJson(entry).value());
    if (!common.json) printLine(stdout, fmt::format("  {:<14} {}", entry.name, text));
  }
  if (common.json) printJson(JsonObject().add("levels", std::move(list)).value());
}

void levels(const LevelsOptions& options, const CommonOptions& common) {
  const std::vector<LevelEntry> entries = listLevels();
  if (options.folder.empty()) return listAll(entries, common);
  makeFolder(options.folder);
  checkAllOutputs(entries, options, common.noClobber);
  if (!common.json) {
    printLine(stdout, fmt::format("{:<14} {:>9} {:>9} {:>9} {:>9} {:>7} {:>7}  {}", "level", "triangles",
                                  "IoU", "p99 px", "agreement", "hidden", "missed", "match"));
  }
  JsonValue list = emptyList();
  std::size_t bad = 0;
  for (const LevelEntry& entry : entries) {
    try {
      list.items.push_back(showLevel(entry, options, common));
    } catch (const Error& error) {  // the others are shown all the same
      printError(error);
      JsonObject json = entryJson(entry);
      if (entry.problem.empty()) json.add("problem", std::string(error.what()));
      list.items.push_back(json.value());
      ++bad;
    }
  }
  if (common.json) {
    printJson(JsonObject().add("levels", std::move(list)).value());
    flushResults();
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
  addSizeOption(*command, options->size, limits::renderedSize.level)->needs(folder);
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { levels(*options, common); });
}

}  // namespace anamorph
