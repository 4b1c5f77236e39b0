// anamorph deform: the sculpture as a mesh file.

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/count.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/input.h"
#include "cli/report.h"
#include "cli/usage_error.h"
#include "exports/export_formats.h"

namespace anamorph {
namespace {

struct DeformOptions {
  InputOptions input;
  std::string output, format;
  std::optional<int> imageSize;  // as in the level
  double millimetresPerUnit = 1;
};

// Vertices that are not mapped keep the original's place, which says nothing about the sculpture.
Box mappedBox(const Sculpture& sculpture) {
  Box box;
  for (std::size_t i = 0; i < sculpture.status.size(); ++i) {
    if (sculpture.status[i] == PathStatus::mapped) box.extend(sculpture.mesh.positions[i]);
  }
  return box;
}

double rounded(double seconds) {
  return std::round(seconds * 1e6) / 1e6;
}

void deform(const DeformOptions& options, const CommonOptions& common) {
  std::vector<Output> outputs = makeOutputs({options.output}, options.format);
  Output& output = outputs.front();
  if (!isMeshFile(output.path()))
    throw UsageError(wrongEnding(output.name(), formatOf(ExportKind::sculpture).endings));
  if (output.isStandardOutput() && common.json) throw UsageError(jsonInTheWay);
  Input input = loadInput(options.input, common, outputs);
  if (options.imageSize) input.level.sculpture.imageSize = *options.imageSize;
  const double deformStart = secondsNow();
  const LevelResult finished = finishInput(input, common);
  const Sculpture& sculpture = *finished.sculpture.sculpture;
  const double writeStart = secondsNow();
  MeshFileOptions file;
  file.scale = options.millimetresPerUnit;
  file.comment =
      "sculpture for the " + std::string(shapeName(input.level.optic.shape())) + " mirror, made by Anamorph";
  sayWarnings(common, saveMesh(output.path(), sculpture.mesh, file));
  output.deliver();
  const double end = secondsNow();

  const bool ownVertices = input.level.sculpture.tolerancePixels == 0;
  if (!common.json) {
    sayMessage(common, output.name() + ": " + countOf(sculpture.mesh.positions.size(), "vertex", "vertices") +
                           ", " + countOf(sculpture.mesh.triangles.size(), "triangle", "triangles"));
    return;
  }
  const Box box = mappedBox(sculpture);
  const double scale = options.millimetresPerUnit;
  printJson(JsonObject()
                .add("vertices", sculpture.mesh.positions.size())
                .add("triangles", sculpture.mesh.triangles.size())
                .add("status", statusJson(sculpture.originalStatus))
                .add("unmappedVertices",
                     std::string(ownVertices ? "original position kept, faces dropped" : "dropped"))
                .add("budgetHit", sculpture.budgetHit)
                .add("bounds", JsonObject().add("min", scale * box.min).add("max", scale * box.max).value())
                .add("seconds", JsonObject()
                                    .add("load", rounded(input.loadSeconds))
                                    .add("deform", rounded(writeStart - deformStart))
                                    .add("write", rounded(end - writeStart))
                                    .value())
                .value());
}

}  // namespace

void addDeformCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command = app.add_subcommand("deform", "Make the sculpture and write it as OBJ, STL or PLY");
  const auto options = std::make_shared<DeformOptions>();
  addInputOptions(*command, options->input);
  command
      ->add_option("-o,--output", options->output,
                   "The file to write: " + exportEndings(ExportKind::sculpture))
      ->required();
  addFormat(*command, options->format);
  addNoClobber(*command, common);
  command
      ->add_option("--image-size", options->imageSize,
                   "Height of the image that the tolerance is meant for (default: the level's)")
      ->check(numberIn(limits::imageSize));
  command->add_option("--mm-per-unit", options->millimetresPerUnit, "Millimetres per scene unit in the file")
      ->check(numberIn(limits::millimetresPerUnit.level));
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { deform(*options, common); });
}

}  // namespace anamorph
