// Wavefront OBJ: `v` and `f` lines (`fo`, as old programs write it). Texture coordinates, groups and materials are skipped,
// and normals where nobody wants them, lines and curves left out. Positions keep the file's order, so that a seam in the texture does not
// split a position.
#pragma once

#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"
#include "geometry/mesh_remarks.h"
#include "geometry/smooth_mesh.h"

namespace anamorph {

/// The mesh in an OBJ file's bytes, as loadMesh promises. Throws Error.
Mesh readObj(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits = {});

/// The same with the file's normals (`vn`), unit; corners without one have that of their faces, as the whole file when it
/// has none (withSmoothNormals).
SmoothMesh readSmoothObj(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits = {});

}  // namespace anamorph
