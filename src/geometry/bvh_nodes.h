// What a Bvh is made of: plain data, laid out for the memory cache.
//
// Float coordinates are relative to `centre`, so that small meshes far from the origin keep their digits.
// Boxes are a little larger than what they hold, by more than all roundings of the slab test together: no ray
// slips past a box.
#pragma once

#include <cstdint>
#include <vector>

#include "math/vec.h"

namespace anamorph {

/// A node of the binary tree, two RGBA texels large. Node 0 is the root; children come after their parent.
struct alignas(16) BvhNode {
  float min[3] = {0, 0, 0};
  std::uint32_t link = 0;  ///< left child (the right one follows it), or where in `order` a leaf begins
  float max[3] = {0, 0, 0};
  std::uint32_t count = 0;  ///< number of triangles in a leaf, 1 to 4; 0 for an inner node

  bool operator==(const BvhNode&) const = default;
};

/// Eight children at once: the form that the CPU walks. Lanes without a child have an empty box.
struct alignas(64) BvhWideNode {
  static constexpr int width = 8;
  static constexpr std::uint32_t leaf = 0x80000000u;  ///< flag in `child`
  static constexpr std::uint32_t noSource = 0xffffffffu;

  float bounds[3][2][width];    ///< [axis][0 min, 1 max][child]
  std::uint32_t child[width];   ///< a wide node, or leaf | block
  std::uint32_t source[width];  ///< the binary node whose box the child has, or noSource
};

/// The up to four triangles of a leaf, tested at once. Lanes without a triangle have NaN corners, which
/// nothing meets.
struct alignas(16) BvhBlock {
  float corner[3][3][4];      ///< [corner][axis][lane]
  std::uint32_t point[3][4];  ///< [corner][lane], indices of points
  std::uint32_t triangle[4];  ///< indices into the mesh's triangles
};

/// A point's coordinates in one piece, for when a hit asks for three of them.
struct alignas(32) BvhPoint {
  double x, y, z, unused;
};

struct BvhData {
  Point centre{0};
  double radius = 0;  ///< no used point is farther from the centre along any axis
  std::vector<BvhPoint> points;
  std::vector<std::uint32_t> unusedPoints;  ///< those of no triangle, ascending

  std::vector<BvhNode> nodes;
  std::vector<std::uint32_t> order;  ///< the mesh's triangles as the leaves have them
  std::vector<BvhWideNode> wideNodes;
  std::vector<BvhBlock> blocks;
  std::vector<std::uint32_t> blockLeaf;  ///< the binary leaf of each block
};

}  // namespace anamorph
