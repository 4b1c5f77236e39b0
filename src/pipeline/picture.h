// The pictures of a level, as the RT camera takes them.
#pragma once

#include <optional>
#include <utility>

#include "pipeline/level_result.h"
#include "raytrace/image.h"
#include "raytrace/render.h"

namespace anamorph {

enum class PictureKind {
  reflection,  ///< the mirror with the sculpture's reflection
  original,    ///< the original alone, seen directly
  difference,  ///< the original in grey, and in colour where the reflection does not agree with it
};

/// The image of the RT camera whose longer side has `longerSide` pixels; its sides are as the pixel grid's.
/// 0: the pixel grid itself.
std::pair<int, int> pictureSize(const PixelGrid& grid, int longerSide);

/// The match report of a level that has a sculpture, for an image of this size. `obstacle`: something that stands
/// there beside the sculpture, a base plate.
Match matchLevel(const LevelResult& result, int width, int height, int threads = 1,
                 const Progress& progress = {}, std::shared_ptr<const Bvh> obstacle = nullptr);

/// The request the level asks for, at a size.
ImageRequest makeImageRequest(const LevelScene& level, int width, int height, int threads);

/// The difference picture, from the picture of the original and a match of the same size: grey where both
/// agree, coloured where not.
Image markDifferences(Image original, const Match& match);

/// A picture; nothing when cancelled. `match` is needed for the difference only, of the picture's size.
std::optional<Image> makePicture(const LevelResult& result, PictureKind kind, const ImageRequest& request,
                                 const Match* match = nullptr, const Progress& progress = {});

}  // namespace anamorph
