// The text form of STL: solid NAME { facet normal N outer loop vertex P ... endloop endfacet } endsolid NAME. Where
// lines end does not matter, except for the names.
#pragma once

#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"
#include "geometry/mesh_remarks.h"

namespace anamorph {

/// The facets, each with corners of its own. Throws Error for a file that is cut off or too large.
Mesh readTextStl(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits);

}  // namespace anamorph
