// FILE and MODEL of the commands: a level or a scene of the thesis, and a mesh that takes the place of its
// original. Either may be -, standard input.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/common_options.h"
#include "cli/output.h"
#include "level/level_json.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"

namespace anamorph {

struct InputOptions {
  std::string file;
  std::string model;
  std::optional<double> depthScale, depthOffset;
  std::optional<double> tolerancePixels;  ///< 0 is "off"
  std::optional<double> fovDegrees;
  std::string up;       ///< the camera's
  std::string modelUp;  ///< "auto" or one of modelUpNames; empty: as the level says, z for a MODEL
  bool unitize = false;
};

void addInputOptions(CLI::App& command, InputOptions& options);
/// --model-up alone, for commands that take a level in other ways.
void addModelUpOption(CLI::App& command, std::string& modelUp);

/// Which axis of a model `--model-up` means; a guess is said.
ModelUp chooseModelUp(const std::string& modelUp, const UpGuess& guess, const CommonOptions& common);

/// The level with the mesh file of its original turned as `--model-up` says; the level is in the file `path`. Throws
/// UsageError when its original is no mesh file, and Error when that cannot be read.
Level applyModelUp(Level level, const std::string& modelUp, const std::filesystem::path& path,
                   const CommonOptions& common);

struct Input {
  std::string name;  ///< the file, for messages
  Level level;
  PlacedOriginal original{nullptr};  ///< in scene coordinates
  double loadSeconds = 0;
};

/// Reads both files and applies the options. A MODEL for a level is fitted into the box of the level's own
/// original, for a scene of the thesis it keeps its size; --unitize fits it into the unit cube first. A frozen
/// sculpture is another one's then, and follows again (said). `outputs` are checked as soon as it is known which files
/// are read. Throws Error, also when no sculpture can be made of it, and UsageError when a scene comes without a MODEL,
/// or when an option would change a frozen sculpture.
Input loadInput(const InputOptions& options, const CommonOptions& common,
                std::span<const Output> outputs = {});

/// What is named by - is standard input.
bool isStandardInput(const std::string& name);
/// The file or the installed level of that name. Throws UsageError where there is neither.
std::filesystem::path levelNamed(const std::string& name);
/// The level or scene of that name: a file, an installed one, or standard input, and what the file is called. Throws
/// Error, and UsageError as levelNamed().
std::pair<std::string, LoadedLevel> readLevelInput(const std::string& name, const MeshLimits& limits);
/// A level that was read, with the meshes of its mirrors and what there is to say of them; it is in the file `path`.
LoadedLevel withMirrors(LoadedLevel loaded, const std::string& path, const MeshLimits& limits);
/// Throws UsageError when both are standard input, Error for pipes.
void checkInputs(const std::string& level, const std::string& model);
/// Throws Error for a pipe, such as <(...) makes: those are read as standard input.
void checkInput(const std::string& name);

/// The files that are read for a level: its own, its meshes, and the MODEL where there is one.
std::vector<std::filesystem::path> filesRead(const std::string& file, const Level& level,
                                             const std::string& model = {});

/// finishLevel, with an Error when nothing of the original comes into the sculpture, and with what is worth a
/// warning.
LevelResult finishInput(const Input& input, const CommonOptions& common);

/// matchLevel and makePicture, with progress bars.
Match matchInput(const LevelResult& finished, int width, int height, const CommonOptions& common);
Image drawInput(const LevelResult& finished, PictureKind kind, const ImageRequest& request,
                const Match* match, const CommonOptions& common);

}  // namespace anamorph
