// Whether a sculpture is seen through its optic with left and right exchanged, and where that differs from the rest of
// it. Both are asked of the rays (ray_bundle.h), never of what the optic is: one reflection exchanges left and right, and
// so does a way beyond a focus.
//
//    R  \   /                 Beyond the place where neighbouring rays cross, the sculpture is turned around once
//        \ /   <- a fold      more. If that is true of a part of it only, this part cannot be joined to the rest: its
//         *                   triangles are `folded`, and are left out. Asked at one distance for all three corners,
//        / \                  because a triangle's own slant would hide the sign.
#pragma once

#include <vector>

#include "anamorphosis/vertex_map.h"
#include "base/progress.h"
#include "geometry/mesh.h"

namespace anamorph {

/// Where the rays of a sculpture cross, beyond the optic, in scene units.
struct FocusRange {
  double nearest = 0, farthest = 0;  ///< 0: nowhere
  bool none() const { return nearest == 0; }
};

struct Folds {
  bool reversed = false;  ///< whether most of it is seen turned around: its triangles have to be turned then
  std::vector<char> folded;  ///< 1 for every triangle that differs from that; empty: none does
  std::size_t count = 0;     ///< of them
  double share = 0;          ///< of what the eye sees of all triangles that are mapped
  FocusRange foci;           ///< of the folded triangles' rays
};

/// Of the triangles whose corners are all mapped; others are not folded. A cancelled run finds none. Where all that the
/// eye sees of the optic bulges towards it there are no folds, and only some triangles are asked which way round they
/// are.
Folds findFolds(const VertexMap& map, const PointArray& original, const std::vector<Triangle>& triangles,
                const std::vector<PathStatus>& status, int threads = 1, const CancelToken& token = {});

}  // namespace anamorph
