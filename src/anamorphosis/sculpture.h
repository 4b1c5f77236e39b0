// From an original to its sculpture: the lesson's algorithm, whole.
//
// With a tolerance the mesh is refined until the reflection's edges are that straight in the image
// (refine.h). With tolerance 0 ("off") the original's own vertices are used, as in the thesis: an 8-vertex
// cube then shows why vertices matter (its figures 8 and 9).
#pragma once

#include <cstdint>
#include <vector>

#include "anamorphosis/deform_input.h"
#include "anamorphosis/folds.h"
#include "anamorphosis/map_points.h"
#include "base/progress.h"
#include "geometry/mesh.h"

namespace anamorph {

/// What was left out because it is folded (folds.h).
struct LeftOutFolds {
  std::size_t triangles = 0;
  double share = 0;  ///< of what the eye sees of all that is mapped
  FocusRange foci;   ///< where the rays of these triangles cross
};

struct Sculpture {
  Mesh mesh;            ///< triangles have all corners mapped and are not folded; winding outward again
  PointArray original;  ///< the original's point behind every vertex
  std::vector<PathStatus> status;             ///< of every vertex
  std::vector<VertexSource> source;           ///< of every vertex
  std::vector<std::uint32_t> sourceTriangle;  ///< the original's triangle behind every triangle
  LeftOutFolds folded;
  StatusCounts originalStatus{};    ///< over the original's own vertices
  bool budgetHit = false;           ///< finer was wanted than maxTriangles allows
  double remainingErrorPixels = 0;  ///< the largest edge error left, known when the budget was hit
};

/// Tolerance 0: vertices as in the original, in its order; those not mapped keep their original position and
/// their triangles are left out, as folded ones are. Otherwise: equal positions are joined, the mesh refined, unused vertices
/// left out. A cancelled run returns an empty sculpture.
Sculpture makeSculpture(const DeformInput& input, int threads = 1, const Progress& progress = {});

/// Where the points behind the sculpture's vertices are on its original, which may have moved since.
void placeSources(const Sculpture& sculpture, const Mesh& original, PointArray& points);

/// The sculpture of a drag: the same triangles and sources, all of sculpture.original mapped anew. Triangles stay,
/// so corners that are not mapped any more are left at their original's place with their status telling so.
void remapSculpture(const VertexMap& map, Sculpture& sculpture, int threads = 1);

}  // namespace anamorph
