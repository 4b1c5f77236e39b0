// What a sculpture is made from, and how its vertices remember the original.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "anamorphosis/vertex_map.h"
#include "geometry/mesh.h"
#include "optics/camera.h"

namespace anamorph {

struct DeformInput {
  std::shared_ptr<const Mesh> original;  ///< in scene coordinates
  VertexMap map;                         ///< with mistakes the original's own vertices are used
  Camera camera;                         ///< at the map's eye; its image is what the tolerance is measured in
  int imageSize = 512;                   ///< height of that image in pixels
  double tolerancePixels = 0.25;         ///< 0: the original's own vertices
  std::size_t maxTriangles = 2000000;    ///< refinement stops there

  bool operator==(const DeformInput&) const = default;
};

/// Where a vertex comes from: a triangle of the original and barycentrics on it,
/// point = (1 - u - v) a + u b + v c.
struct VertexSource {
  std::uint32_t triangle = 0;
  double u = 0, v = 0;
};

}  // namespace anamorph
