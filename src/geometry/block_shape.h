// Solids made of blocks on a grid of planes, such as a box or a block letter. Only the faces between inside
// and outside are made, every one cut into segments x segments quads, so neighbours always meet vertex to
// vertex.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "geometry/mesh.h"

namespace anamorph {

/// planes[axis] are the ascending places where blocks end; block (i, j, k) lies between planes i and i + 1 of
/// x, and so on, and is solid when `isSolid` says so (it is asked for blocks inside the grid only). Welded,
/// outward, and closed unless solid blocks touch in nothing but an edge or a corner.
Mesh makeBlockShape(const std::array<std::vector<double>, 3>& planes,
                    const std::function<bool(const std::array<int, 3>&)>& isSolid, int segments);

}  // namespace anamorph
