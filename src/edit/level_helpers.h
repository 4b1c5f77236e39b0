// What a maker of levels would have to find by trying: how large the original may be, how high the eye has to
// be. Pure functions from a level to a better one; nothing when there is none.
//
//      fit:                                  lift:             e'
//                  mirror  ...[ s P ]                         /  .  up to 85 degrees, at the same distance,
//      eye ----------)-----[ P ]                         e ../....P  until nothing stands before the mirror
//                          ...
#pragma once

#include <memory>
#include <optional>

#include "base/progress.h"
#include "geometry/mesh.h"
#include "level/level.h"

namespace anamorph {

/// The original (`placed`: in scene coordinates) scaled by one factor about the middle of its box, as large as it may
/// be while every vertex ray meets the mirror and goes on, and nothing of the reflection is hidden or missed; less 2 %.
/// The level itself when nothing larger is as good as it is. Nothing when no size will do, or when cancelled.
std::optional<Level> originalFittedToMirror(const Level& level, std::shared_ptr<const Mesh> placed,
                                            int threads = 1, const Progress& progress = {});

/// The eye turned upwards around the middle of the original, at the same distance, to the smallest height
/// where the sculpture hides nothing of its reflection and the mirror misses no more of it than before; found
/// by matches of small images. The level itself when nothing is hidden. Nothing when no height will do, or
/// when cancelled.
std::optional<Level> eyeLifted(const Level& level, std::shared_ptr<const Mesh> placed, int threads = 1,
                               const Progress& progress = {});

/// Of a small image, as the search has it: whether the level can be computed and there is something to judge, and
/// what is hidden and missed.
struct CoarseView {
  bool sound = false;
  double hiddenShare = 0, missedShare = 0;

  bool clear() const { return sound && hiddenShare == 0 && missedShare == 0; }
};
CoarseView coarseView(const Level& level, std::shared_ptr<const Mesh> placed, int size, int threads = 1,
                      const Progress& progress = {});

}  // namespace anamorph
