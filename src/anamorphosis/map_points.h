// The kernel: every original vertex along its vertex ray. One call maps a million vertices in a few
// milliseconds, which is why the sculpture can follow the mouse.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "anamorphosis/vertex_map.h"
#include "geometry/mesh.h"

namespace anamorph {

/// How many vertices have each status, by the status' number.
using StatusCounts = std::array<std::size_t, pathStatusCount>;

struct MappedPoints {
  PointArray points;               ///< sculpture vertices; the original's where not mapped
  std::vector<PathStatus> status;  ///< one per vertex
};

/// mapPoint for every vertex, in order; identical to it for every thread count. `result` is reused: no memory
/// is taken when it has the right size already.
void mapPointsThrough(const VertexMap& map, const PointArray& original, MappedPoints& result,
                      int threads = 1);

StatusCounts countStatus(const std::vector<PathStatus>& status);

}  // namespace anamorph
