#include "pipeline/evaluator.h"

#include <utility>

#include "level/freeze.h"

namespace anamorph {

// Cancelled is thrown through Memo, so that nothing half-made is kept, and caught here.

void Evaluator::makeSculptureOf(LevelResult& result, int threads, const Progress& progress) {
  const Level& level = result.level;
  result.refined = true;
  result.problem = findSculptureProblem(level, sourceBox(result));
  if (result.problem) {
    result.sculpture = emptySculpture({});
    return;
  }
  result.sculpture = sculpture_.get(makeDeformInput(level, result.source), [&](const DeformInput& input) {
    Sculpture sculpture = makeSculpture(input, threads, progress);
    if (progress.cancelled()) throw Cancelled();
    return prepareSculpture(std::move(sculpture), threads);
  });
  const Sculpture& sculpture = *result.sculpture.sculpture;
  result.problem = findEmptiness(sculpture);
  if (!result.problem) {
    result.warnings = findWarnings(level, result.sculpture);
    result.problem = findProblem(level, result.original.box);  // of a frozen one, which is there all the same
  } else if (!sculpture.mesh.triangles.empty()) {              // triangles without area
    result.sculpture = emptySculpture(sculpture.originalStatus);
  }
}

std::optional<LevelResult> Evaluator::deform(const Level& level, PlacedOriginal original, int threads,
                                             const Progress& progress) {
  LevelResult result;
  result.level = level;
  result.original = prepareMesh(std::move(original.mesh), threads);
  result.source = std::move(original.source);
  try {
    makeSculptureOf(result, threads, progress);
  } catch (const Cancelled&) {
    return std::nullopt;
  }
  return result;
}

Evaluator::SharedMatch Evaluator::match(const LevelResult& result, int longerSide,
                                        Memo<MatchInput, SharedMatch>& memo, int threads,
                                        const Progress& progress) {
  const auto [width, height] = pictureSize(result.level.grid, longerSide);
  return memo.get(makeMatchInput(result.level, result.original, result.sculpture, width, height),
                  [&](const MatchInput& in) {
                    auto match = std::make_shared<const Match>(computeMatch(in, threads, progress));
                    if (progress.cancelled()) throw Cancelled();
                    return match;
                  });
}

void Evaluator::takePictures(LevelResult& result, int previewSize, int threads, const OnPart& onPart,
                             const Progress& progress) {
  const Level& level = result.level;
  const auto [width, height] = pictureSize(level.grid, previewSize);
  const ImageRequest request = makeImageRequest(level, width, height, threads);
  const auto take = [&](SceneInput scene, Memo<PictureKey, SharedImage>& memo, SharedImage& picture,
                        const Progress& part) {
    picture = memo.get({std::move(scene), level.camera, request}, [&](const PictureKey& key) {
      auto image = renderProgressive(
          buildScene(key.scene), key.camera, key.request,
          [&](const Image& coarse, int) {
            picture = std::make_shared<const Image>(coarse);
            if (onPart) onPart(result);
          },
          part);
      if (!image) throw Cancelled();
      return std::make_shared<const Image>(std::move(*image));
    });
    if (onPart) onPart(result);
  };
  take(makeReflectionScene(level, result.sculpture), reflection_, result.previews.reflection,
       partOf(progress, 0, 0.7));
  take(makeOriginalScene(level, result.original), originalPicture_, result.previews.original,
       partOf(progress, 0.7, 0.9));
  if (result.problem) return;  // there is nothing to compare
  const SharedMatch match =
      this->match(result, previewSize, previewMatch_, threads, partOf(progress, 0.9, 1));
  result.previews.difference =
      difference_.get({result.previews.original, match}, [](const DifferenceKey& key) {
        return std::make_shared<const Image>(markDifferences(*key.original, *key.match));
      });
}

std::optional<LevelResult> Evaluator::evaluate(const EvaluationInput& input, int threads,
                                               const OnPart& onPart, const Progress& progress) {
  LevelResult result;
  result.level = input.level;
  const Level& level = input.level;
  const auto tell = [&] {
    if (onPart) onPart(result);
    if (progress.cancelled()) throw Cancelled();
  };
  try {
    const LoadedOriginal loaded = shape_.get(
        {level.original.shape, input.levelPath},
        [&](const ShapeKey& key) { return loadOriginal(key.shape, key.levelPath, {}, &progress.token); });
    result.shape = loaded.mesh;
    result.shapeWarnings = loaded.warnings;
    if (progress.cancelled()) return std::nullopt;
    result.original = original_.get(
        {result.shape, level.original.unitize, level.original.placement}, [&](const PlaceKey& key) {
          return prepareMesh(placeOriginal(*key.shape, key.unitized, key.placement), threads);
        });
    // Asked for always, so that freezing and moving the original find the mesh that the sculpture was made from.
    const SculptureInputs inputs = sculptureInputs(level);
    result.source = source_.get({result.shape, inputs.unitize, inputs.placement}, [&](const PlaceKey& key) {
      if (!hasOriginalMoved(level)) return result.original.mesh;
      return placeOriginal(*key.shape, key.unitized, key.placement);
    });
    if (!progress.update(0.15)) return std::nullopt;
    makeSculptureOf(result, threads, partOf(progress, 0.15, 0.5));
    tell();
    if (!result.problem) result.match = match(result, matchSize, match_, threads, partOf(progress, 0.5, 0.6));
    tell();
    takePictures(result, input.previewSize, threads, onPart, partOf(progress, 0.6, 1));
  } catch (const Cancelled&) {
    return std::nullopt;
  }
  result.complete = true;
  if (onPart) onPart(result);
  return result;
}

std::optional<LevelResult> finishLevel(const Level& level, PlacedOriginal original, int threads,
                                       const Progress& progress) {
  return Evaluator().deform(level, std::move(original), threads, progress);
}

}  // namespace anamorph
