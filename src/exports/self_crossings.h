// Where a surface goes through itself: pairs of triangles that cross and are no neighbours. Every triangle
// asks the tree of boxes for the triangles that it could meet; of two, the one with the smaller number asks.
#pragma once

#include <optional>

#include "base/progress.h"
#include "geometry/bvh.h"

namespace anamorph {

struct SelfCrossings {
  std::size_t pairs = 0;         ///< of triangles without a common corner
  bool more = false;             ///< counting stopped there
  std::optional<Point> example;  ///< the middle of a triangle of the first pair
};

/// Counts up to about `limit` pairs. Corners are the same when their indices are: weld first. `bvh` is of the
/// mesh. The same for every thread count. Nothing when cancelled.
std::optional<SelfCrossings> countSelfCrossings(const Mesh& mesh, const Bvh& bvh, std::size_t limit,
                                                int threads = 1, const Progress& progress = {});

}  // namespace anamorph
