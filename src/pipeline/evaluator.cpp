#include "pipeline/evaluator.h"

#include <algorithm>
#include <cmath>

#include "pipeline/original.h"

namespace anamorph {
namespace {

// For what a stage was cancelled in: thrown through Memo so that nothing half-made is kept, caught in
// settle().
struct Cancelled {};

}  // namespace

std::pair<int, int> pictureSize(const Camera& camera, int longerSide) {
  const int columns = std::max(1, camera.gridColumns), rows = std::max(1, camera.gridRows);
  if (longerSide <= 0) return {columns, rows};
  const double scale = double(longerSide) / std::max(columns, rows);
  return {std::max(1, int(std::lround(columns * scale))), std::max(1, int(std::lround(rows * scale)))};
}

bool Evaluator::deform(Settled& settled, int threads, const Progress& progress) {
  const Level& level = settled.input.level;
  settled.problem = findProblem(level, *settled.original.mesh);
  if (settled.problem) {
    settled.sculpture = prepareSculpture({}, threads);
    return false;
  }
  const DeformInput input = makeDeformInput(level, settled.original.mesh);
  settled.sculpture = sculpture_.get(input, [&](const DeformInput& in) {
    Sculpture sculpture = makeSculpture(in, threads, progress);
    if (progress.cancelled()) throw Cancelled();
    return prepareSculpture(std::move(sculpture), threads);
  });
  const Sculpture& sculpture = *settled.sculpture.sculpture;
  settled.problem = findEmptiness(sculpture);
  if (!settled.problem) {
    settled.warnings = findWarnings(level, sculpture);
    return true;
  }
  if (!sculpture.mesh.triangles.empty()) {  // triangles without area
    Sculpture empty;
    empty.originalStatus = sculpture.originalStatus;
    settled.sculpture = prepareSculpture(std::move(empty), threads);
  }
  return false;
}

Evaluator::SharedMatch Evaluator::match(const Settled& settled, int longerSide,
                                        Memo<MatchInput, SharedMatch>& memo, int threads,
                                        const Progress& progress) {
  const auto [width, height] = pictureSize(settled.input.level.camera, longerSide);
  return memo.get(makeMatchInput(settled.input.level, settled.original, settled.sculpture, width, height),
                  [&](const MatchInput& in) {
                    auto match = std::make_shared<const Match>(computeMatch(in, threads, progress));
                    if (progress.cancelled()) throw Cancelled();
                    return match;
                  });
}

void Evaluator::takePictures(Settled& settled, int threads, const OnPart& onPart, const Progress& progress) {
  const Level& level = settled.input.level;
  const auto [width, height] = pictureSize(level.camera, settled.input.previewSize);
  const ImageRequest request = makeImageRequest(level, width, height, threads);
  const auto take = [&](SceneInput scene, Memo<PictureKey, SharedImage>& memo, SharedImage& picture,
                        const Progress& part) {
    picture = memo.get({std::move(scene), level.camera, request}, [&](const PictureKey& key) {
      auto image = renderProgressive(
          buildScene(key.scene), key.camera, key.request,
          [&](const Image& coarse, int) {
            picture = std::make_shared<const Image>(coarse);
            if (onPart) onPart(settled);
          },
          part);
      if (!image) throw Cancelled();
      return std::make_shared<const Image>(std::move(*image));
    });
    if (onPart) onPart(settled);
  };
  take(makeReflectionScene(level, settled.sculpture), reflection_, settled.previews.reflection,
       partOf(progress, 0, 0.7));
  take(makeOriginalScene(level, settled.original), originalPicture_, settled.previews.original,
       partOf(progress, 0.7, 0.9));
  if (settled.problem) return;  // there is nothing to compare
  const SharedMatch match =
      this->match(settled, settled.input.previewSize, previewMatch_, threads, partOf(progress, 0.9, 1));
  settled.previews.difference =
      std::make_shared<const Image>(markDifferences(*settled.previews.original, *match));
}

std::optional<Settled> Evaluator::evaluate(const EvaluationInput& input, int threads, const OnPart& onPart,
                                           const Progress& progress) {
  Settled settled;
  settled.input = input;
  const Level& level = input.level;
  const auto tell = [&] {
    if (onPart) onPart(settled);
    if (progress.cancelled()) throw Cancelled();
  };
  try {
    settled.shape = shape_.get({level.original.shape, input.levelPath},
                               [](const ShapeKey& key) { return loadOriginal(key.shape, key.levelPath); });
    if (progress.cancelled()) return std::nullopt;
    settled.original = original_.get(
        {settled.shape, level.original.unitize, level.original.placement}, [&](const PlaceKey& key) {
          return prepareMesh(placeOriginal(*key.shape, key.unitized, key.placement), threads);
        });
    if (!progress.update(0.15)) return std::nullopt;
    const bool mapped = deform(settled, threads, partOf(progress, 0.15, 0.5));
    tell();
    if (mapped) settled.match = match(settled, matchSize, match_, threads, partOf(progress, 0.5, 0.6));
    tell();
    takePictures(settled, threads, onPart, partOf(progress, 0.6, 1));
  } catch (const Cancelled&) {
    return std::nullopt;
  }
  settled.complete = true;
  if (onPart) onPart(settled);
  return settled;
}

}  // namespace anamorph
