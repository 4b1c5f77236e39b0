// The sculpture as a thing of plastic: only what belongs to a triangle, in millimetres.
#pragma once

#include "geometry/mesh.h"

namespace anamorph {

/// The triangles of a mesh and the positions they use, in their order, multiplied by `millimetresPerUnit`.
/// Throws Error when a coordinate becomes too large to be a number.
Mesh makePrintable(const Mesh& mesh, double millimetresPerUnit);

/// Adds the triangles of `more` to `mesh`, as shells of their own.
void appendMesh(Mesh& mesh, const Mesh& more);

}  // namespace anamorph
