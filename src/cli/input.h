// FILE and MODEL of the commands: a level or a scene of the thesis, and a mesh that takes the place of its
// original.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/common_options.h"
#include "level/level.h"
#include "pipeline/picture.h"

namespace anamorph {

struct InputOptions {
  std::string file;
  std::string model;
  std::optional<double> depthScale;
  std::optional<double> tolerancePixels;  ///< 0 is "off"
  std::optional<double> fovDegrees;
  std::string up;
  bool unitize = false;
};

void addInputOptions(CLI::App& command, InputOptions& options);

struct Input {
  std::string name;  ///< the file, for messages
  Level level;
  std::shared_ptr<const Mesh> original;  ///< in scene coordinates
  double loadSeconds = 0;
};

/// Reads both files and applies the options. A MODEL for a level is fitted into the box of the level's own
/// original, for a scene of the thesis it keeps its size; --unitize fits it into the unit cube first. Throws
/// Error, also when no sculpture can be made of it, and UsageError when a scene comes without a MODEL.
Input loadInput(const InputOptions& options, const CommonOptions& common);

/// finishLevel, with an Error when nothing of the original comes into the sculpture, and with what is worth a
/// warning.
LevelResult finishInput(const Input& input, const CommonOptions& common);

/// matchLevel and makePicture, with progress bars.
Match matchInput(const LevelResult& finished, int width, int height, const CommonOptions& common);
Image drawInput(const LevelResult& finished, PictureKind kind, const ImageRequest& request,
                const Match* match, const CommonOptions& common);

/// Throws Error when this file could not be written, before hours are spent on what is to be in it.
void checkOutput(const std::string& path);

}  // namespace anamorph
