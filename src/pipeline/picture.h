// The pictures of a level, as the RT camera takes them.
#pragma once

#include <optional>

#include "pipeline/stages.h"
#include "raytrace/image.h"
#include "raytrace/render.h"

namespace anamorph {

enum class PictureKind {
  reflection,  ///< the mirror with the sculpture's reflection
  original,    ///< the original alone, seen directly
  difference,  ///< the original in grey, and in colour where the reflection does not agree with it
};

/// Everything that is known of a finished level.
struct FinishedLevel {
  Level level;
  PreparedMesh original;
  PreparedSculpture sculpture;
};

/// From the level and its original in scene coordinates. Nothing when cancelled. Does not throw for what a
/// student can set up: then the sculpture is empty, and findProblem and findEmptiness tell why.
std::optional<FinishedLevel> finishLevel(const Level& level, std::shared_ptr<const Mesh> original,
                                         int threads = 1, const Progress& progress = {});

/// The match report of a finished level, for an image of this size.
Match matchLevel(const FinishedLevel& finished, int width, int height, int threads = 1,
                 const Progress& progress = {});

/// The request the level asks for, at a size.
ImageRequest makeImageRequest(const Level& level, int width, int height, int threads);

/// The difference picture, from the picture of the original and a match of the same size: grey where both
/// agree, coloured where not.
Image markDifferences(Image original, const Match& match);

/// A picture; nothing when cancelled. `match` is needed for the difference only, of the picture's size.
std::optional<Image> makePicture(const FinishedLevel& finished, PictureKind kind, const ImageRequest& request,
                                 const Match* match = nullptr, const Progress& progress = {});

}  // namespace anamorph
