// How thick the walls of a solid are: from many points of its surface a ray goes straight inwards, to where
// it comes out again.
//
//      ___________
//     |  |        \       The points lie evenly over the area (by number, not by chance), so that the first
//     |  v t       \      percentile means: 99 % of the walls are thicker. Towards an edge every solid gets
//     |__*__________\     thinner; that is no wall, so sides that lean to each other by more than 30 degrees
//                         are not counted.
#pragma once

#include <optional>

#include "base/progress.h"
#include "geometry/bvh.h"

namespace anamorph {

struct WallThickness {
  double least = 0;            ///< the smallest thickness found
  Point leastAt{0};            ///< the middle of the wall there
  double firstPercentile = 0;  ///< 99 % of the walls are thicker
  std::size_t samples = 0;     ///< rays that came out again; 0: nothing is known
};

/// Asks `samples` points. `inward` is -1 for a mesh that is inside out, else 1. Nothing when cancelled. The
/// same for every thread count.
std::optional<WallThickness> measureWalls(const Mesh& mesh, const Bvh& bvh, int samples = 65536,
                                          double inward = 1, int threads = 1, const Progress& progress = {});

}  // namespace anamorph
