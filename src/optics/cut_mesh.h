// A mesh cut off by planes: triangles that cross one are cut along it (Sutherland and Hodgman 1974), with new corners on
// their edges.
#pragma once

#include <vector>

#include "geometry/smooth_mesh.h"
#include "math/half_space.h"

namespace anamorph {

/// What lies in all of them. Normals of new corners are unit means of their edge's; without normals there are none.
SmoothMesh cutMesh(const SmoothMesh& surface, const std::vector<HalfSpace>& planes);

}  // namespace anamorph
