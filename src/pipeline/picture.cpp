#include "pipeline/picture.h"

#include <utility>

#include "base/check.h"
#include "math/palette.h"

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

std::optional<FinishedLevel> finishLevel(const Level& level, std::shared_ptr<const Mesh> original,
                                         int threads, const Progress& progress) {
  FinishedLevel finished{level, prepareMesh(std::move(original), threads), {}};
  Sculpture sculpture;
  if (!findProblem(level, *finished.original.mesh)) {
    sculpture = makeSculpture(makeDeformInput(level, finished.original.mesh), threads, progress);
  }
  if (progress.cancelled()) return std::nullopt;
  finished.sculpture = prepareSculpture(std::move(sculpture), threads);
  return finished;
}

Match matchLevel(const FinishedLevel& finished, int width, int height, int threads,
                 const Progress& progress) {
  return computeMatch(makeMatchInput(finished.level, finished.original, finished.sculpture, width, height),
                      threads, progress);
}

ImageRequest makeImageRequest(const Level& level, int width, int height, int threads) {
  ImageRequest request;
  request.width = width;
  request.height = height;
  request.samplesPerAxis = level.tracing.samplesPerAxis;
  request.maxDepth = level.tracing.maxDepth;
  request.shadows = level.tracing.shadows;
  request.threads = threads;
  return request;
}

std::optional<Image> makePicture(const FinishedLevel& finished, PictureKind kind, const ImageRequest& request,
                                 const Match* match, const Progress& progress) {
  const Level& level = finished.level;
  const bool reflection = kind == PictureKind::reflection;
  const RenderScene scene = buildScene(reflection ? makeReflectionScene(level, finished.sculpture)
                                                  : makeOriginalScene(level, finished.original));
  std::optional<Image> image = render(scene, level.camera, request, progress);
  if (!image || kind != PictureKind::difference) return image;
  CHECK(match != nullptr);
  return markDifferences(std::move(*image), *match);
}

}  // namespace anamorph
