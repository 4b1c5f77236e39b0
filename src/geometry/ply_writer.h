// PLY out: binary, little-endian, positions as doubles, so nothing is lost and it is smaller than OBJ.
#pragma once

#include <string>

#include "base/file.h"
#include "geometry/mesh.h"

namespace anamorph {

/// Writes the whole file; the caller commits it.
void writePly(AtomicFile& file, const Mesh& mesh, const std::string& comment);

}  // namespace anamorph
