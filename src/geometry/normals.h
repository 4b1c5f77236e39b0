// Shading normals by crease angle: faces that meet at less than the crease angle share a smooth normal,
// sharper edges stay sharp. Which corners share a normal is decided once, on the original; while the
// sculpture is dragged only the normals themselves are computed again.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/mesh.h"
#include "geometry/smooth_mesh.h"

namespace anamorph {

/// For every triangle corner the index of its normal; corners with the same index are shaded smoothly
/// together.
struct NormalGroups {
  std::vector<Triangle> corners;  ///< one per triangle, indices into the normals
  std::size_t count = 0;          ///< number of normals
};

/// Corners of neighbouring faces share a normal when the faces meet at an edge with at most `creaseDegrees`
/// between their face normals. Positions should be welded.
NormalGroups makeNormalGroups(const Mesh& mesh, double creaseDegrees = 30);

/// One unit normal a group: the sum of the area vectors of its corners' triangles, normalised (0 0 1 where
/// that vanishes). Float: they are only shaded with.
std::vector<glm::vec3> computeNormals(const PointArray& points, const std::vector<Triangle>& triangles,
                                      const NormalGroups& groups, int threads = 1);

/// The mesh with such normals, in double: light is reflected by them.
SmoothMesh withSmoothNormals(Mesh mesh, double creaseDegrees = 30);

}  // namespace anamorph
