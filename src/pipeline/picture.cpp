#include "pipeline/picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "level/limits.h"
#include "math/palette.h"
#include "raytrace/tracer.h"

namespace anamorph {
Image markDifferences(Image picture, const Match& match) {
  CHECK(match.classes.size() == picture.pixels.size());
  const glm::vec3 onlyOriginal = lightShownAs(palette::onlyOriginal),
                  onlyReflection = lightShownAs(palette::onlyReflection),
                  hidden = lightShownAs(palette::hiddenReflection), missed = lightShownAs(palette::noMirror);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    glm::vec3& pixel = picture.pixels[i];
    switch (match.classes[i]) {
      case PixelClass::background:
      case PixelClass::both: {
        const float grey = glm::dot(pixel, glm::vec3(0.2126f, 0.7152f, 0.0722f));
        pixel = glm::vec3(match.classes[i] == PixelClass::both ? grey : 0.5f + 0.5f * grey);
        break;
      }
      case PixelClass::onlyOriginal:
        pixel = onlyOriginal;
        break;
      case PixelClass::onlyReflection:
        pixel = onlyReflection;
        break;
      case PixelClass::hidden:
        pixel = hidden;
        break;
      case PixelClass::missed:
        pixel = missed;
        break;
    }
  }
  return picture;
}

std::pair<int, int> pictureSize(const PixelGrid& grid, int longerSide) {
  const int columns = std::max(1, grid.columns), rows = std::max(1, grid.rows);
  if (longerSide <= 0) return {columns, rows};
  const double scale = double(longerSide) / std::max(columns, rows);
  return {std::max(1, int(std::lround(columns * scale))), std::max(1, int(std::lround(rows * scale)))};
}

Match matchLevel(const LevelResult& result, int width, int height, int threads, const Progress& progress,
                 std::shared_ptr<const Bvh> obstacle) {
  MatchInput input = makeMatchInput(result.level, result.original, result.sculpture, width, height);
  input.obstacle = std::move(obstacle);
  return computeMatch(input, threads, progress);
}

ImageRequest makeImageRequest(const LevelScene& level, int width, int height, int threads) {
  ImageRequest request;
  request.width = width;
  request.height = height;
  request.samplesPerAxis = level.tracing.samplesPerAxis;
  static_assert(limits::reflections.max == maxTraceDepth);
  request.maxDepth = level.tracing.maxDepth;
  request.shadows = level.tracing.shadows;
  request.threads = threads;
  return request;
}

std::optional<Image> makePicture(const LevelResult& result, PictureKind kind, const ImageRequest& request,
                                 const Match* match, const Progress& progress) {
  const Level& level = result.level;
  const bool reflection = kind == PictureKind::reflection;
  const RenderScene scene = buildScene(reflection ? makeReflectionScene(level, result.sculpture)
                                                  : makeOriginalScene(level, result.original));
  std::optional<Image> image = render(scene, level.camera, request, progress);
  if (!image || kind != PictureKind::difference) return image;
  CHECK(match != nullptr);
  return markDifferences(std::move(*image), *match);
}

}  // namespace anamorph
