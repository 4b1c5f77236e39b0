// Makes everything of a level: its original, its sculpture refined, its match, its pictures. One function for the
// window's worker, for commands, screenshots and tests. Each stage is kept as long as its own input stays the
// same, so a moved light costs a picture and not a refinement.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "pipeline/memo.h"
#include "pipeline/original.h"
#include "pipeline/picture.h"

namespace anamorph {

/// What the result depends on: of the level its scene only.
struct EvaluationInput {
  Level level;
  std::filesystem::path levelPath;  ///< mesh files are relative to it
  int previewSize = 256;            ///< longer side of the pictures in pixels; 0: the pixel grid's resolution

  bool operator==(const EvaluationInput& other) const {
    return isSameScene(level, other.level) && levelPath == other.levelPath &&
           previewSize == other.previewSize;
  }
};

/// The longer side of the image that the match compares, as the command line has it.
constexpr int matchSize = 512;

class Evaluator {
 public:
  /// Called with what is known so far, more each time, from the calling thread. Pictures come coarse first.
  using OnPart = std::function<void(const LevelResult&)>;

  /// All of a level. Nothing when cancelled. Throws Error when the original cannot be read.
  std::optional<LevelResult> evaluate(const EvaluationInput& input, int threads, const OnPart& onPart = {},
                                      const Progress& progress = {});

  /// Original and sculpture of a level whose original is in scene coordinates, with what is wrong and what is
  /// worth knowing; no match, no pictures. Nothing when cancelled.
  std::optional<LevelResult> deform(const Level& level, PlacedOriginal original, int threads,
                                    const Progress& progress = {});

 private:
  struct ShapeKey {
    OriginalShape shape;
    std::filesystem::path levelPath;
    bool operator==(const ShapeKey&) const = default;
  };
  struct PlaceKey {
    std::shared_ptr<const Mesh> shape;
    bool unitized;
    Placement placement;
    bool operator==(const PlaceKey&) const = default;
  };
  struct PictureKey {
    SceneInput scene;
    Camera camera;
    ImageRequest request;
    bool operator==(const PictureKey&) const = default;
  };
  using SharedMatch = std::shared_ptr<const Match>;
  using SharedImage = std::shared_ptr<const Image>;

  struct DifferenceKey {
    SharedImage original;
    SharedMatch match;
    bool operator==(const DifferenceKey&) const = default;
  };

  void makeSculptureOf(LevelResult& result, int threads, const Progress& progress);
  SharedMatch match(const LevelResult& result, int longerSide, Memo<MatchInput, SharedMatch>& memo,
                    int threads, const Progress& progress);
  void takePictures(LevelResult& result, int previewSize, int threads, const OnPart& onPart,
                    const Progress& progress);

  Memo<ShapeKey, LoadedOriginal> shape_;
  Memo<PlaceKey, PreparedMesh> original_;
  Memo<PlaceKey, std::shared_ptr<const Mesh>> source_;
  Memo<DeformInput, PreparedSculpture> sculpture_;
  Memo<MatchInput, SharedMatch> match_, previewMatch_;
  Memo<PictureKey, SharedImage> reflection_, originalPicture_;
  Memo<DifferenceKey, SharedImage> difference_;
};

/// Evaluator::deform, once. Nothing when cancelled. Does not throw for what a student can set up: then there is a
/// problem, and the sculpture is empty.
std::optional<LevelResult> finishLevel(const Level& level, PlacedOriginal original, int threads = 1,
                                       const Progress& progress = {});

}  // namespace anamorph
