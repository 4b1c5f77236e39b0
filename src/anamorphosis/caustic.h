// Where the rays from the eye cross beyond a mirror: the caustic, drawn as points. Every thin bundle of rays has up to two
// focal points (ray_bundle.h); all first ones and all second ones lie on two surfaces.
#pragma once

#include <vector>

#include "anamorphosis/vertex_map.h"
#include "geometry/mesh.h"

namespace anamorph {

struct CausticPoint {
  Point at{0};
  bool second = false;  ///< on the farther surface of both

  bool operator==(const CausticPoint&) const = default;
};

/// Of the rays towards `count` of the original's vertices (in scene coordinates), evenly over its list, where they come
/// there freely and not flatter than the map takes; those that are farther from the mirror than `farthest` times as far
/// as the sculpture are left out.
std::vector<CausticPoint> findCaustic(const VertexMap& map, const PointArray& original, std::size_t count,
                                      double farthest = 8);

}  // namespace anamorph
