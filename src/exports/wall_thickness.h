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
#include <vector>

#include "base/progress.h"
#include "geometry/bvh.h"

namespace anamorph {

/// The middle of a wall, and how thick it is there.
struct ThinPlace {
  Point at{0};
  double thickness = 0;
};

struct WallThickness {
  ThinPlace least;                ///< the thinnest that was found
  double firstPercentile = 0;     ///< 99 % of the walls are thicker
  double thinArea = 0;            ///< of the surface, both sides, where walls are thinner than asked for
  std::vector<ThinPlace> places;  ///< where they are: the thinnest first, apart from each other, a few
  std::size_t samples = 0;        ///< rays that came out again; 0: nothing is known
};

struct WallQuestion {
  double thin = 0;  ///< what is thinner than this is a thin wall
  int samples = 65536;
  double inward = 1;  ///< -1 for a mesh that is inside out
};

/// Nothing when cancelled. The same for every thread count.
std::optional<WallThickness> measureWalls(const Mesh& mesh, const Bvh& bvh, const WallQuestion& question,
                                          int threads = 1, const Progress& progress = {});

}  // namespace anamorph
