// Whether a sculpture is seen through its optic with left and right exchanged: then its triangles have to be
// turned around, so that outside stays outside. That is asked of the result, never of what the optic is: one
// reflection exchanges them, and so do many things beyond a focus.
//
//   D0 D1 D2 from the eye            A thin bundle of eye rays has an area at distance d beyond the optic,
//     \ | /                          spread(d) = ((q1 + d r1) x (q2 + d r2)) . R,   q1 = Q1 - Q0, r1 = R1 - R0, ...
//    --Q0Q1Q2-- optic                Its sign against that of the bundle at the eye, det(D0 D1 D2), tells
//     / | \ R                        (method-optics section 5). Triangles seen edge-on weigh little.
#pragma once

#include <vector>

#include "anamorphosis/vertex_map.h"
#include "geometry/mesh.h"

namespace anamorph {

/// By the majority of some of the triangles whose corners are all mapped; false when there are none.
bool reversesHandedness(const VertexMap& map, const PointArray& original,
                        const std::vector<Triangle>& triangles, const std::vector<PathStatus>& status);

}  // namespace anamorph
