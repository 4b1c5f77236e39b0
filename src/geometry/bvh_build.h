// The parts of making a Bvh. The binary tree is built top-down, each node split where the binned surface-area
// heuristic (Wald 2007) expects the fewest tests for a random ray; then eight children at a time are
// collapsed into wide nodes; last come the coordinates, which is all that a refit does. The result does not
// depend on the number of threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/bvh_nodes.h"
#include "geometry/mesh.h"

namespace anamorph {

/// No leaf is deeper, whatever the triangles are, so a traversal's stack has a fixed size.
constexpr int bvhMaxDepth = 64;
constexpr std::uint32_t bvhLeafSize = 4;

/// The box of one triangle, and which triangle that is.
struct alignas(32) BvhPrimitive {
  float min[3];
  std::uint32_t triangle;
  float max[3];
  std::uint32_t unused;
};

/// Nodes over the primitives, which are put into the order of the leaves. At least one primitive. Where a
/// branch comes near to `maxDepth`, its triangles are halved instead of split well.
std::vector<BvhNode> buildBinaryTree(std::vector<BvhPrimitive>& primitives, int threads,
                                     int maxDepth = bvhMaxDepth);

struct BvhWideTree {
  std::vector<BvhWideNode> nodes;     ///< without bounds, those are copied from the sources
  std::vector<std::uint32_t> leaves;  ///< for each block, the leaf of the binary tree
};

/// The same tree with eight children a node, as full as can be.
BvhWideTree collapseTree(const std::vector<BvhNode>& nodes);

/// Sets centre and radius. `absent` as for Bvh::refit, here and below.
void placeFrame(BvhData& data, const PointArray& points, std::span<const std::uint8_t> absent = {});

/// Sets every coordinate of points, blocks and nodes; topology is in place.
void placePoints(BvhData& data, const PointArray& points, int threads,
                 std::span<const std::uint8_t> absent = {});

}  // namespace anamorph
