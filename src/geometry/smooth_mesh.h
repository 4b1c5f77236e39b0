// A mesh with a normal at every corner: what is tessellated of a curved surface, or read from a file that has normals.
#pragma once

#include <vector>

#include "geometry/mesh.h"

namespace anamorph {

struct SmoothMesh {
  Mesh mesh;
  PointArray normals;             ///< unit
  std::vector<Triangle> corners;  ///< of every triangle, its corners' normals; empty: as the triangles

  bool operator==(const SmoothMesh&) const = default;
  const Triangle& normalsOf(std::size_t triangle) const {
    return corners.empty() ? mesh.triangles[triangle] : corners[triangle];
  }
};

/// The largest angle between a triangle and the normal at one of its corners, whichever side that is on; triangles
/// without area have none.
double largestKinkDegrees(const SmoothMesh& surface);

}  // namespace anamorph
