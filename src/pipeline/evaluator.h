// Everything that is known of a level at rest: its original, its sculpture refined, its match, its pictures.
// One function for the window's worker, for screenshots and for tests. Each stage is kept as long as its own
// input stays the same, so a moved light costs a picture and not a refinement.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pipeline/memo.h"
#include "pipeline/picture.h"

namespace anamorph {

struct EvaluationInput {
  Level level;
  std::filesystem::path levelPath;  ///< mesh files are relative to it
  int previewSize = 256;            ///< longer side of the pictures in pixels; 0: the pixel grid's resolution

  bool operator==(const EvaluationInput&) const = default;
};

/// The three pictures of the preview, all of one size; null when not made yet.
struct Previews {
  std::shared_ptr<const Image> reflection;
  std::shared_ptr<const Image> original;
  std::shared_ptr<const Image> difference;

  bool operator==(const Previews&) const = default;
};

struct Settled {
  EvaluationInput input;
  std::shared_ptr<const Mesh> shape;  ///< the original before it is placed
  PreparedMesh original;
  PreparedSculpture sculpture;         ///< without triangles when there is a problem
  std::optional<std::string> problem;  ///< why nothing can be made, and what to do
  std::vector<std::string> warnings;
  std::shared_ptr<const Match> match;
  Previews previews;
  bool complete = false;  ///< nothing is missing any more
};

/// The image of the RT camera whose longer side has `longerSide` pixels; its sides are as the pixel grid's.
/// 0: the pixel grid itself.
std::pair<int, int> pictureSize(const Camera& camera, int longerSide);

/// The longer side of the image that the match compares, as the command line has it.
constexpr int matchSize = 512;

class Evaluator {
 public:
  /// Called with what is known so far, more each time, from the calling thread. Pictures come coarse first.
  using OnPart = std::function<void(const Settled&)>;

  /// Nothing when cancelled. Throws Error when the original cannot be read.
  std::optional<Settled> evaluate(const EvaluationInput& input, int threads, const OnPart& onPart = {},
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

  /// Whether there is a sculpture; else the problem says why not.
  bool deform(Settled& settled, int threads, const Progress& progress);
  SharedMatch match(const Settled& settled, int longerSide, Memo<MatchInput, SharedMatch>& memo, int threads,
                    const Progress& progress);
  void takePictures(Settled& settled, int threads, const OnPart& onPart, const Progress& progress);

  Memo<ShapeKey, std::shared_ptr<const Mesh>> shape_;
  Memo<PlaceKey, PreparedMesh> original_;
  Memo<DeformInput, PreparedSculpture> sculpture_;
  Memo<MatchInput, SharedMatch> match_, previewMatch_;
  Memo<PictureKey, SharedImage> reflection_, originalPicture_;
};

}  // namespace anamorph
