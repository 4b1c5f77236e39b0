// From an original to its sculpture: the lesson's algorithm, whole.
//
// With a tolerance the mesh is refined until the reflection's edges are that straight in the image
// (refine.h). With tolerance 0 ("off") the original's own vertices are used, as in the thesis: an 8-vertex
// cube then shows why vertices matter (its figures 8 and 9).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "anamorphosis/map_points.h"
#include "base/progress.h"
#include "geometry/mesh.h"
#include "optics/camera.h"

namespace anamorph {

struct DeformInput {
  std::shared_ptr<const Mesh> original;  ///< in scene coordinates
  VertexMap map;                       ///< with mistakes the original's own vertices are used
  Camera camera;                       ///< at the map's eye; its image is what the tolerance is measured in
  int imageSize = 512;                 ///< height of that image in pixels
  double tolerancePixels = 0.25;       ///< 0: the original's own vertices
  std::size_t maxTriangles = 2000000;  ///< refinement stops there

  bool operator==(const DeformInput&) const = default;
};

/// Where a vertex comes from: a triangle of the original and barycentrics on it,
/// point = (1 - u - v) a + u b + v c.
struct VertexSource {
  std::uint32_t triangle = 0;
  double u = 0, v = 0;
};

struct Sculpture {
  Mesh mesh;                                  ///< triangles have all corners mapped; winding outward again
  PointArray original;                        ///< the original's point behind every vertex
  std::vector<PathStatus> status;             ///< of every vertex
  std::vector<VertexSource> source;           ///< of every vertex
  std::vector<std::uint32_t> sourceTriangle;  ///< the original's triangle behind every triangle
  StatusCounts originalStatus{};              ///< over the original's own vertices
  bool budgetHit = false;                     ///< finer was wanted than maxTriangles allows
  double remainingErrorPixels = 0;            ///< the largest edge error left, known when the budget was hit
};

/// Tolerance 0: vertices as in the original, in its order; those not mapped keep their original position and
/// their triangles are left out. Otherwise: equal positions are joined, the mesh refined, unused vertices
/// left out. A cancelled run returns an empty sculpture.
Sculpture makeSculpture(const DeformInput& input, int threads = 1, const Progress& progress = {});

/// The sculpture of a drag: the same triangles and sources, all of sculpture.original mapped anew. Triangles stay,
/// so corners that are not mapped any more are left at their original's place with their status telling so.
void remapSculpture(const VertexMap& map, Sculpture& sculpture, int threads = 1);

}  // namespace anamorph
