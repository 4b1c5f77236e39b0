// Refinement: the sculpture is as fine as the image needs, and no finer (method section 5).
//
// Edges are judged one by one and split in the middle where the straight edge is seen to be off its curve, so
// both triangles of an edge agree and no crack opens:
//
//      one edge           two edges           three edges
//          *                  *                    *
//         /|\                / \                  / \      Each halving makes the error
//        / | \              *---*                *---*     four times smaller (fact F8),
//       /  |  \            / `-. \              / \ / \    so a few rounds are enough.
//      *---*---*          *-------*            *---*---*
#pragma once

#include <cstdint>
#include <vector>

#include "anamorphosis/deform_input.h"
#include "anamorphosis/map_points.h"
#include "base/progress.h"

namespace anamorph {

/// A mesh that is being refined: originals and images of its vertices, and triangles over both.
struct Refinement {
  PointArray original;
  MappedPoints mapped;
  std::vector<Triangle> triangles;            // in the original's winding
  std::vector<std::uint32_t> sourceTriangle;  // of every triangle
  std::vector<VertexSource> source;           // of every vertex
  bool budgetHit = false;
  double remainingErrorPixels = 0;
};

/// Refines the welded original of `input`. `budgetHit` when maxTriangles stopped it: the worst edges come
/// first.
Refinement refine(const Mesh& welded, const DeformInput& input, int threads, const Progress& progress);

}  // namespace anamorph
