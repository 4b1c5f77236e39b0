// What a maker of levels would have to find by trying: how large the original may be, how high the eye has to be, how far
// behind the mirror the original. Pure functions from a level to a better one, never to a worse one: every answer has been
// matched in the size that everybody judges by.
//
//      fit:                                  lift:             e'
//                  mirror  ...[ s P ]                         /  .  up to 85 degrees, at the same distance,
//      eye ----------)-----[ P ]                         e ../....P  until nothing stands before the mirror
//                          ...
//      put behind:
//      eye --[ P ]---)-----[ P' ]--->
//
// All take the original in scene coordinates (`placed`), and try so many levels at most however it goes. Nothing when there
// is no answer, when cancelled, and for a frozen sculpture, which would not follow.
#pragma once

#include <memory>
#include <optional>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "level/level.h"

namespace anamorph {

/// The original scaled by one factor about the middle of its box, as large as it may be while every vertex ray meets the
/// mirror and goes on, and nothing of the reflection is hidden or missed; less 2 %. The level itself when nothing larger
/// is as good as it is.
std::optional<Level> originalFittedToMirror(const Level& level, std::shared_ptr<const Mesh> placed,
                                            int threads = 1, const Progress& progress = {});

/// The eye turned upwards around the middle of the original, at the same distance, to the smallest height where nothing of
/// the reflection is hidden or missed; where there is none, to the smallest where nothing is hidden and no more missed
/// than before. Heights are looked at in steps of 2 degrees. The level itself when nothing is hidden.
std::optional<Level> eyeLifted(const Level& level, std::shared_ptr<const Mesh> placed, int threads = 1,
                               const Progress& progress = {});

/// The original moved along the line of sight to the nearest place behind the mirror (level_repairs.h) where nothing of
/// the reflection is hidden or missed. Where there is none within eight times the distance: to the place where most of it is
/// seen, if that is more than before. The level itself when it is at such a place already.
std::optional<Level> originalPutBehind(const Level& level, std::shared_ptr<const Mesh> placed,
                                       int threads = 1, const Progress& progress = {});

}  // namespace anamorph
