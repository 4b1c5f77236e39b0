// Which shells of a surface are inside out. Facing inwards is no fault by itself: a hollow does, and has to. What counts
// is the outermost shell around it:
//
//      .--------.  faces outwards:            .--------.  faces inwards: inside out,
//      |  .--.  |  so all is well,            |  .--.  |  and with it all that is inside
//      |  '--'  |  hollows too                |  '--'  |
//      '--------'                             '--------'
#pragma once

#include "exports/surface_topology.h"

namespace anamorph {

/// The numbers of the closed shells that have to be turned, for the outermost ones to face outwards. `surface` is of the
/// mesh. An open shell has no inside, and what is within one stays as it is.
std::vector<std::size_t> findInsideOut(const Mesh& mesh, const Surface& surface);

}  // namespace anamorph
