// STL, text and binary. STL has no indices: every triangle repeats its corners, so corners with equal
// coordinates are welded. Its normals and attributes are skipped; the order of the corners says which side is
// outside.
#pragma once

#include <string>
#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"

namespace anamorph {

/// The welded mesh in an STL file's bytes, as loadMesh promises; `file` is the name for messages. Throws
/// Error.
Mesh readStl(std::string_view bytes, const std::string& file, const MeshLimits& limits = {});

/// Whether bytes that are no PLY are rather STL than OBJ: they begin with the word solid, or are no text.
bool looksLikeStl(std::string_view bytes);

}  // namespace anamorph
