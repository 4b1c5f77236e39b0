// The binary form of STL: 80 bytes of text, the number of triangles, and 50 bytes a triangle. The number is wrong in
// many files; the size of the file is not.
#pragma once

#include <cstddef>
#include <string_view>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"
#include "geometry/mesh_remarks.h"

namespace anamorph {

/// Whether the number of triangles in a file's head agrees with its size.
bool isExactBinaryStl(std::string_view head, std::size_t fileSize);

/// The triangles, each with corners of its own. Throws Error for a file that is cut off or too large.
Mesh readBinaryStl(std::string_view bytes, MeshRemarks& remarks, const MeshLimits& limits);

}  // namespace anamorph
