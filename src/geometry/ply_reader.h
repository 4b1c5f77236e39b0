// PLY: text, binary little- and big-endian. Of the element `vertex` x, y and z are read, of `face` the list
// vertex_indices (or vertex_index); other properties and elements are skipped, whatever their order.
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"

namespace anamorph {

/// The mesh in a PLY file's bytes, as loadMesh promises; `file` is the name for messages, in which vertices
/// and faces are counted from 0, as in the file. Throws Error.
Mesh readPly(std::string_view bytes, const std::string& file, const MeshLimits& limits = {});

}  // namespace anamorph
