// Wavefront OBJ out: `v` lines with the shortest numbers that read back to the same doubles, and `f` lines.
#pragma once

#include <string>

#include "base/file.h"
#include "geometry/mesh.h"

namespace anamorph {

/// Writes the whole file; the caller commits it.
void writeObj(AtomicFile& file, const Mesh& mesh, const std::string& comment);

/// The same as a text, without a comment.
std::string formatObj(const Mesh& mesh);

}  // namespace anamorph
