// Wavefront OBJ: `v` and `f` lines. Everything else (texture coordinates, normals, groups, materials, curves)
// is skipped. Positions keep the file's order, so that a seam in the texture does not split a position.
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"

namespace anamorph {

/// The mesh in an OBJ file's bytes, as loadMesh promises; `file` is the name for messages. Throws Error.
Mesh readObj(std::string_view bytes, const std::string& file, const MeshLimits& limits = {});

}  // namespace anamorph
