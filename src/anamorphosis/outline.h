// Where the silhouettes of original and reflection end in the compared picture, finer than its pixels: pixels at an
// end are asked once more, in 4 x 4 places each.
//
//      pixels         at an end
//     . . . . .      . . . . .       An outline is the points midway between two neighbouring places of which one
//     . . # # #      . +-+-+-+       shows the thing and the other does not. What is wholly between two pixels'
//     . # # # #      +-+ # # #       samples is not seen.
//     . # # # #      + # # # #
//
// Where something hides the reflection, or the mirror ends, the reflection's outline follows the original's: hidden
// and missed shares say what is lacking there, the outlines how well that agrees which can be seen.
#pragma once

#include <functional>
#include <vector>

#include "anamorphosis/match_classes.h"
#include "base/progress.h"
#include "math/vec.h"

namespace anamorph {

struct Outlines {
  std::vector<Pixel> original, reflection;
};

/// `classes`: of the pixels, row by row; `classAt`: of any place, called from several threads. Empty when cancelled.
Outlines findOutlines(const std::vector<PixelClass>& classes, int width, int height,
                      const std::function<PixelClass(const Pixel&)>& classAt, int threads,
                      const Progress& progress);

}  // namespace anamorph
