// STL, text and binary. STL has no indices: every triangle repeats its corners, so corners with equal
// coordinates are welded. Its normals and attributes are skipped; the order of the corners says which side is
// outside. What else programs write is read too: facets of four and more corners, a wrong number of triangles in a
// binary file's head (the file's size counts), names, capitals and ends that are missing or in two words.
#pragma once

#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"
#include "geometry/mesh_remarks.h"

namespace anamorph {

/// The welded mesh in an STL file's bytes, as loadMesh promises. Throws Error.
Mesh readStl(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits = {});

}  // namespace anamorph
