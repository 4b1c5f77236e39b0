// anamorph check: what is wrong with a level, a scene or a mesh, and where.

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/print.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "pipeline/evaluator.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

std::string checkMesh(const LoadedMesh& loaded, const std::string& file, const CommonOptions& common) {
  sayWarnings(common, loaded.warnings);
  const Mesh& mesh = loaded.mesh;
  const Vector size = boundingBox(mesh.positions).size();
  const WeldedMesh welded = weldPositions(mesh);
  if (welded.mesh.triangles.empty()) throw Error("expected triangles with an area, got none", file);
  return fmt::format("mesh, {} vertices, {} triangles, {:.4g} x {:.4g} x {:.4g}, {}", mesh.positions.size(),
                     mesh.triangles.size(), size.x, size.y, size.z,
                     isClosed(welded.mesh) ? "closed" : "not closed");
}

std::string checkScene(const Level& level) {
  // The mesh is not known, but its place is: the problems of mirror and eye show with that point alone.
  Box point;
  point.extend(level.original.placement.position);
  if (auto problem = findProblem(level, point)) throw Error(*problem);
  return fmt::format("thesis scene, {} mirror", shapeName(level.optic.shape()));
}

std::string checkLevel(const std::string& path, const Level& level, const CommonOptions& common) {
  constexpr int matchSize = 256;
  const auto shape = loadOriginal(level.original.shape, path, common.meshLimits());
  sayWarnings(common, shape.warnings);
  const LevelResult finished = *finishLevel(level, placeOriginal(*shape.mesh, level), common.threads);
  if (finished.problem) throw Error(*finished.problem);
  const Sculpture& sculpture = *finished.sculpture.sculpture;
  for (const std::string& warning : finished.warnings)
    sayMessage(common, "warning: " + path + ": " + warning);
  const MatchReport report = matchLevel(finished, matchSize, matchSize, common.threads).report;
  if (const auto problem = findMatchProblem(report)) sayMessage(common, "warning: " + path + ": " + *problem);
  return fmt::format("level \"{}\", {} {}, {} of {} vertices mapped, match {}", level.text->title,
                     shapeName(level.optic.shape()), surfaceName(level.optic), sculpture.originalStatus[0],
                     shape.mesh->positions.size(), matchGradeName(gradeOf(report)));
}

std::string checkLoaded(const std::string& path, const LoadedLevel& loaded, const CommonOptions& common) {
  sayWarnings(common, loaded.warnings);
  try {
    return loaded.isThesisScene ? checkScene(loaded.level) : checkLevel(path, loaded.level, common);
  } catch (const Error& error) {
    if (!error.file.empty()) throw;
    throw Error(error.message, path);
  }
}

// Levels are JSON objects, meshes never begin like one.
bool looksLikeJson(std::string_view bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return first != std::string_view::npos && bytes[first] == '{';
}

std::string checkStandardInput(const CommonOptions& common) {
  const MeshLimits limits = common.meshLimits();
  const FileBytes bytes = readStandardInput(limits.maxBytes, MeshLimits::bytesHelp);
  const std::string name = standardInputName;
  if (looksLikeJson(bytes.view())) return checkLoaded(name, parseLevel(bytes.view(), name), common);
  return checkMesh(readMesh(bytes.view(), name, limits), name, common);
}

std::string checkFile(const std::string& file, const CommonOptions& common) {
  if (isStandardInput(file)) return checkStandardInput(common);
  checkInput(file);
  if (isModelFile(file)) return checkMesh(loadMesh(file, common.meshLimits()), file, common);
  const std::string path = findLevel(file).string();
  return checkLoaded(path, loadLevel(path), common);
}

void check(const std::vector<std::string>& files, const CommonOptions& common) {
  std::size_t bad = 0;
  for (const std::string& file : files) {
    flushResults();  // in order with what goes to stderr
    try {
      printLine(stdout, file + ": " + checkFile(file, common));
    } catch (const Error& error) {
      printLine(stderr, error.what());
      ++bad;
    }
  }
  if (bad > 0) throw Error(fmt::format("{} of {} files have faults", bad, files.size()));
}

}  // namespace

void addCheckCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command =
      app.add_subcommand("check", "Tell what is wrong with levels, thesis scenes and meshes, and where");
  const auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files, "Levels, thesis scenes or meshes; - for standard input")->required();
  addCommonOptions(*command, common);
  command->callback([files, &common] { check(*files, common); });
}

}  // namespace anamorph
