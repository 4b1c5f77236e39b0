// PLY: text, binary little- and big-endian. Of the element `vertex` x, y and z are read, of `face` the list
// vertex_indices (or vertex_index), of `tristrips` the same list as strips of triangles that -1 ends; other
// properties and elements are skipped, whatever their order.
#pragma once

#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"
#include "geometry/mesh_remarks.h"

namespace anamorph {

/// The mesh in a PLY file's bytes, as loadMesh promises; in messages vertices and faces are counted from 0, as in the
/// file. Throws Error.
Mesh readPly(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits = {});

}  // namespace anamorph
