#include "geometry/smooth_mesh.h"

#include <algorithm>
#include <cmath>

namespace anamorph {

double largestKinkDegrees(const SmoothMesh& surface) {
  double least = 1;  // cosine
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const Vector area = areaVector(surface.mesh.positions, surface.mesh.triangles[t]);
    const double length = glm::length(area);
    if (!(length > 0)) continue;
    for (const std::uint32_t normal : surface.normalsOf(t))
      least = std::min(least, std::abs(glm::dot(area, surface.normals[normal])) / length);
  }
  return degrees(std::acos(least));
}

}  // namespace anamorph
