// Binary STL out: float coordinates, facet normals from the order of the corners.
#pragma once

#include <string>

#include "base/file.h"
#include "geometry/mesh.h"

namespace anamorph {

/// Writes the whole file; the caller commits it. `name` is for messages: throws Error when the mesh has no
/// triangles or coordinates beyond float.
void writeStl(AtomicFile& file, const Mesh& mesh, const std::string& comment, const std::string& name);

}  // namespace anamorph
