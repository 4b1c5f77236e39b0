#include "cli/input.h"

#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/usage_error.h"
#include "level/freeze.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "level/surface_files.h"
#include "pipeline/evaluator.h"
#include "pipeline/mirror_files.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

// "off" or a number of pixels.
std::string checkTolerance(std::string& text) {
  if (text == "off") {
    text = "0";
    return {};
  }
  const std::string problem = numberIn(limits::tolerance.level)(text);
  return problem.empty() ? problem : "expected off or " + problem.substr(std::string("expected ").size());
}

LoadedMesh loadModel(const std::string& name, const MeshLimits& limits) {
  if (!isStandardInput(name)) return loadMesh(name, limits);
  const FileBytes bytes = readStandardInput(limits.maxBytes, MeshLimits::bytesHelp);
  return readMesh(bytes.view(), standardInputName, limits);
}

std::shared_ptr<const Mesh> replaceOriginal(const InputOptions& options, const CommonOptions& common,
                                            const std::string& levelPath, bool isScene, Level& level) {
  LoadedMesh model = loadModel(options.model, common.meshLimits());
  sayWarnings(common, model.warnings);
  if (!options.modelUp.empty())
    model.mesh = standUp(std::move(model.mesh), chooseModelUp(options.modelUp, model.up, common));
  if (isScene || options.unitize) return placeOriginal(model.mesh, options.unitize, level.original.placement);
  const auto own = loadOriginal(level.original.shape, levelPath, common.meshLimits()).mesh;
  const auto placed = placeOriginal(*own, level.original.unitize, level.original.placement);
  return std::make_shared<const Mesh>(fitInto(std::move(model.mesh), boundingBox(placed->positions)));
}

// Of what a frozen sculpture is made from nothing is changed.
void checkFrozen(const InputOptions& options, const std::string& path) {
  const bool turns = !options.modelUp.empty() && options.model.empty();
  if (!options.depthScale && !options.depthOffset && !options.unitize && !turns) return;
  throw UsageError(fmt::format("{}: its sculpture is frozen, and {} would change it", path,
                               options.depthScale    ? "--depth-scale"
                               : options.depthOffset ? "--depth-offset"
                               : options.unitize     ? "--unitize"
                                                     : "--model-up"));
}

void applyOptions(const InputOptions& options, Level& level) {
  if (options.depthScale) level.sculpture.depthScale = *options.depthScale;
  if (options.depthOffset) level.sculpture.depthOffset = *options.depthOffset;
  if (options.tolerancePixels) level.sculpture.tolerancePixels = *options.tolerancePixels;
  if (options.fovDegrees) level.camera.fovDegrees = *options.fovDegrees;
  if (options.up == "y") level.camera.up = {0, 1, 0};
  if (options.up == "z") level.camera.up = {0, 0, 1};
}

}  // namespace

void addInputOptions(CLI::App& command, InputOptions& options) {
  command
      .add_option("FILE", options.file,
                  "A level (a file, the name of an installed one, or - for standard input) or a thesis scene")
      ->required();
  command.add_option("MODEL", options.model,
                     "An OBJ, STL or PLY mesh, or -, that takes the place of the original");
  command
      .add_option("--depth-scale", options.depthScale,
                  "How far the sculpture reaches: d = offset + k |P - Q|")
      ->check(numberIn(limits::depthScale.level));
  command
      .add_option("--depth-offset", options.depthOffset,
                  "How far it is from the mirror besides, in scene units (beyond a focus)")
      ->check(numberIn(limits::depthOffset.level));
  command
      .add_option("--tolerance", options.tolerancePixels,
                  "Refine until edges are this straight, in pixels; off: the original's own vertices")
      ->transform(CLI::Validator(checkTolerance, "PX|off"));
  command.add_option("--fov", options.fovDegrees, "Vertical field of view in degrees (thesis scenes: 40)")
      ->check(numberIn(limits::fieldOfView.level));
  command
      .add_option(
          "--up", options.up,
          "Which way is up for the camera (thesis scenes: z); a model is turned by --model-up instead")
      ->check(CLI::IsMember({"z", "y"}));
  addModelUpOption(command, options.modelUp);
  command.add_flag("--unitize", options.unitize, "Centre the original and fit it into the unit cube first");
}

void addModelUpOption(CLI::App& command, std::string& modelUp) {
  std::vector<std::string> names(modelUpNames.begin(), modelUpNames.end());
  names.push_back("auto");
  command
      .add_option("--model-up", modelUp,
                  "Which axis of the mesh file points up, in the file (default: z, or as the level says); "
                  "auto: a guess")
      ->check(CLI::IsMember(names));
}

ModelUp chooseModelUp(const std::string& modelUp, const UpGuess& guess, const CommonOptions& common) {
  if (modelUp != "auto") return *findModelUp(modelUp);
  sayMessage(common, upGuessText(guess));
  return guess.up;
}

Level applyModelUp(Level level, const std::string& modelUp, const std::filesystem::path& path,
                   const CommonOptions& common) {
  auto* file = std::get_if<FileShape>(&level.original.shape);
  if (!file) throw UsageError("--model-up: expected a mesh file, got a level with a built-in original");
  const UpGuess guess =
      modelUp == "auto" ? loadOriginal(level.original.shape, path, common.meshLimits()).up : UpGuess{};
  file->up = chooseModelUp(modelUp, guess, common);
  return level;
}

bool isStandardInput(const std::string& name) {
  return name == "-";
}

LoadedLevel withMirrors(LoadedLevel loaded, const std::string& path, const MeshLimits& limits) {
  for (std::string& warning : readMirrorFiles(loaded.level, path, limits))
    loaded.warnings.push_back(std::move(warning));
  return loaded;
}

std::filesystem::path levelNamed(const std::string& name) {
  try {
    return findLevel(name);
  } catch (const Error& error) {
    levelFolder();  // that there are no levels at all is another fault
    throw UsageError(error.what());
  }
}

std::pair<std::string, LoadedLevel> readLevelInput(const std::string& name, const MeshLimits& limits) {
  if (isStandardInput(name)) {
    return {standardInputName,
            withMirrors(parseLevel(readStandardInput(maxLevelBytes).view(), standardInputName),
                        standardInputName, limits)};
  }
  const std::string path = levelNamed(name).string();
  return {path, withMirrors(loadLevel(path), path, limits)};
}

void checkInputs(const std::string& level, const std::string& model) {
  if (isStandardInput(level) && isStandardInput(model)) {
    throw UsageError("-: expected one file from standard input, got two");
  }
  for (const std::string& name : {level, model}) checkInput(name);
}

void checkInput(const std::string& name) {
  std::error_code ignored;
  if (!std::filesystem::is_fifo(name, ignored)) return;
  throw Error("expected a file, got a pipe; name it -, and let standard input come from it", name);
}

std::vector<std::filesystem::path> filesRead(const std::string& file, const Level& level,
                                             const std::string& model) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : {file, model}) {
    if (!name.empty()) files.push_back(isStandardInput(name) ? "/dev/stdin" : name);
  }
  if (auto mesh = meshFileOf(level, file)) files.push_back(std::move(*mesh));
  for (std::filesystem::path& surface : surfaceFilesOf(level, file)) files.push_back(std::move(surface));
  return files;
}

Input loadInput(const InputOptions& options, const CommonOptions& common, std::span<const Output> outputs) {
  const double start = secondsNow();
  if (isModelFile(options.file)) {
    throw UsageError(options.file +
                     " is a mesh: name a level or a scene first, then the mesh, for example: "
                     "anamorph match 2-cylinder " +
                     options.file);
  }
  checkInputs(options.file, options.model);
  auto [path, loaded] = readLevelInput(options.file, common.meshLimits());
  const std::string& read = isStandardInput(options.file) ? options.file : path;
  checkOutputs(filesRead(read, loaded.level, options.model), outputs, common.noClobber);
  sayWarnings(common, loaded.warnings);
  Input input{path, std::move(loaded.level)};
  if (loaded.isThesisScene && options.model.empty()) {
    throw UsageError(
        path +
        " is a scene of the thesis: it says where the mesh stands, but not which. Name one after it, "
        "for example: anamorph match " +
        path + " model.obj");
  }
  if (input.level.sculpture.frozen && !options.model.empty()) {
    sayMessage(common, path + ": its sculpture was frozen; with another original it follows again");
    input.level = following(std::move(input.level));
  }
  if (input.level.sculpture.frozen) checkFrozen(options, path);
  if (!options.model.empty()) {
    input.original = replaceOriginal(options, common, path, loaded.isThesisScene, input.level);
  } else {
    if (!options.modelUp.empty())
      input.level = applyModelUp(std::move(input.level), options.modelUp, path, common);
    const auto own = loadOriginal(input.level.original.shape, path, common.meshLimits());
    sayWarnings(common, own.warnings);
    input.level.original.unitize |= options.unitize;
    input.original = placeOriginal(*own.mesh, input.level);
  }
  applyOptions(options, input.level);
  if (loaded.isThesisScene) input.level.camera.target = boundingBox(input.original.mesh->positions).centre();
  const Box box = boundingBox(input.original.mesh->positions);
  if (auto problem = findProblem(input.level, box)) {
    throw Error(*problem, path, loaded.isThesisScene ? "" : placeOfProblem(input.level));
  }
  input.loadSeconds = secondsNow() - start;
  return input;
}

LevelResult finishInput(const Input& input, const CommonOptions& common) {
  const LevelResult finished = [&] {
    const ProgressBar bar(common, "deforming");
    return *finishLevel(input.level, input.original, common.threads, bar.progress());
  }();
  if (finished.problem) throw Error(*finished.problem, input.name);
  sayWarnings(common, finished.warnings);
  return finished;
}

Match matchInput(const LevelResult& finished, int width, int height, const CommonOptions& common) {
  const ProgressBar bar(common, "matching");
  return matchLevel(finished, width, height, common.threads, bar.progress());
}

Image drawInput(const LevelResult& finished, PictureKind kind, const ImageRequest& request,
                const Match* match, const CommonOptions& common) {
  const ProgressBar bar(common, "rendering");
  return *makePicture(finished, kind, request, match, bar.progress());
}

}  // namespace anamorph
