// anamorph render: a ray-traced picture from the RT camera.

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/input.h"
#include "cli/usage_error.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

struct RenderOptions {
  InputOptions input;
  std::string output;
  std::pair<int, int> size{512, 512};
  PictureKind picture = PictureKind::reflection;
  int samples = 0;  // 0: as in the level
  double maxMegapixels = 64;
};

void render(const RenderOptions& options, const CommonOptions& common) {
  Output output = pictureOutput(options.output, common);
  const auto [width, height] = options.size;
  const double megapixels = 1e-6 * width * height;
  if (megapixels > options.maxMegapixels) {
    throw UsageError(
        fmt::format("--size: expected at most {:g} megapixels, got {:.1f}; --max-megapixels raises the limit",
                    options.maxMegapixels, megapixels));
  }
  Input input = loadInput(options.input, common, {&output, 1});
  input.level.sculpture.imageSize = std::max(input.level.sculpture.imageSize, height);
  if (options.samples > 0) input.level.tracing.samplesPerAxis = options.samples;
  const PictureKind kind = options.picture;
  LevelResult finished;
  finished.level = input.level;
  Match match;
  if (kind == PictureKind::original) {
    finished.original = prepareMesh(input.original.mesh, common.threads);  // no sculpture is needed for it
  } else {
    finished = finishInput(input, common);
  }
  if (kind == PictureKind::difference) match = matchInput(finished, width, height, common);
  const Image image =
      drawInput(finished, kind, makeImageRequest(input.level, width, height, common.threads), &match, common);
  sayWarnings(common, savePng(output.path(), image));
  output.deliver();
  sayPicture(common, output, width, height, pictureName(kind));
}

}  // namespace

void addRenderCommand(CLI::App& app, CommonOptions& common) {
  CLI::App* command = app.add_subcommand("render", "Ray-trace what the RT camera sees, as PNG");
  const auto options = std::make_shared<RenderOptions>();
  addInputOptions(*command, options->input);
  command->add_option("-o,--output", options->output, "The PNG file to write; - for standard output")
      ->required();
  addNoClobber(*command, common);
  addSizeOption(*command, options->size);
  addPictureOption(*command, options->picture, "What is shown");
  command
      ->add_option("--samples", options->samples,
                   "Samples along each side of a pixel, 1 to 4 (default: the level's)")
      ->check(numberIn(limits::samplesPerAxis));
  command
      ->add_option("--max-megapixels", options->maxMegapixels,
                   "Largest picture to make, in 10^6 pixels (default 64)")
      ->check(numberIn(limits::megapixels));
  addJsonOption(*command, common);
  addCommonOptions(*command, common);
  command->callback([options, &common] { render(*options, common); });
}

}  // namespace anamorph
