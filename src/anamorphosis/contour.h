// How far two outlines of one picture are apart: what counts for a silhouette, be it large or thin. (Pixels in both
// over pixels in either, the IoU, punish thin ones: of a wire two pixels wide a shift by half a pixel takes a third.)
//
//        .----.            Each outline is known as points on it. From every point of one the way to the nearest
//       / .----.           point of the other, and back; of all these ways the 99th of 100 in order.
//      | | --> |  ways
//       \ '----'           Asked both ways, because what only one of them has is far from the other one only.
//        '----'
#pragma once

#include <vector>

#include "math/vec.h"

namespace anamorph {

constexpr double farthestContour = 16;  ///< pixels; what is farther counts as so far

/// In the unit of the points, pixels; farthestContour at most, and where one of them has no points at all.
/// 0 when neither has any.
double contourDistance(const std::vector<Pixel>& a, const std::vector<Pixel>& b);

}  // namespace anamorph
