// The construction as an animation: every vertex of the sculpture on its way along its vertex ray, from the
// original's point P straight to the mirror point Q and on along the reflected ray to S (method section 2).
//
//      P t = 0
//       \                All vertices start together and go at the same speed; those with a shorter way |PQ| + |QS|
//     ---Q------ mirror  arrive before the last one. So the sculpture passes through a flat mirror bit by bit and
//       /                never lies in it as a whole, where its sides could not be told apart.
//      S t = 1
#pragma once

#include "anamorphosis/sculpture.h"

namespace anamorph {

/// The positions of sculpture.mesh at t = 0..1: exactly sculpture.original at 0, exactly the sculpture at 1.
/// Vertices that are not mapped stay. `map` is the one it was made by. `threads` as for parallelFor.
PointArray morphPoints(const Sculpture& sculpture, const VertexMap& map, double t, int threads = 1);

}  // namespace anamorph
