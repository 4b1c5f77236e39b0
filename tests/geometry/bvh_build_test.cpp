#include "geometry/bvh_build.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/bvh.h"
#include "geometry/random_mesh.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

TEST(BvhBuild, IsTheSameForEveryThreadCount) {
  const Mesh mesh = makeTorusKnot(2, 3, 0.3, 400, 40);
  const Bvh one(mesh.positions, mesh.triangles, 1);
  for (const int threads : {2, 4, 0}) {
    const Bvh several(mesh.positions, mesh.triangles, threads);
    EXPECT_EQ(one.nodes(), several.nodes());
    EXPECT_EQ(one.triangleOrder(), several.triangleOrder());
  }
  Bvh refitted = one;
  refitted.refit(mesh.positions, 3);
  EXPECT_EQ(one.nodes(), refitted.nodes());
}

/// Checks the subtree: boxes hold what is below them, leaves follow each other. Returns its depth.
int checkSubtree(const Bvh& bvh, const Mesh& mesh, std::uint32_t index, std::size_t& nextTriangle) {
  const BvhNode& node = bvh.nodes()[index];
  const auto holds = [&](const auto& min, const auto& max) {
    for (int axis = 0; axis < 3; ++axis) {
      if (min[axis] < node.min[axis] || max[axis] > node.max[axis]) return false;
    }
    return true;
  };
  if (node.count > 0) {
    EXPECT_LE(node.count, 4u);
    EXPECT_EQ(node.link, nextTriangle);
    nextTriangle += node.count;
    for (std::uint32_t i = node.link; i < node.link + node.count; ++i) {
      for (const std::uint32_t corner : mesh.triangles[bvh.triangleOrder()[i]]) {
        const Point p = mesh.positions[corner] - bvh.centre();
        EXPECT_TRUE(holds(p, p));
      }
    }
    return 0;
  }
  EXPECT_GT(node.link, index);
  int depth = 0;
  for (const std::uint32_t child : {node.link, node.link + 1}) {
    EXPECT_TRUE(holds(bvh.nodes()[child].min, bvh.nodes()[child].max));
    depth = std::max(depth, 1 + checkSubtree(bvh, mesh, child, nextTriangle));
  }
  return depth;
}

int checkTree(const Mesh& mesh) {
  const Bvh bvh(mesh.positions, mesh.triangles);
  std::vector<std::uint32_t> sorted = bvh.triangleOrder();
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted.size(), mesh.triangles.size());
  for (std::uint32_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i);
  std::size_t nextTriangle = 0;
  const int depth = checkSubtree(bvh, mesh, 0, nextTriangle);
  EXPECT_EQ(nextTriangle, mesh.triangles.size());
  return depth;
}

TEST(BvhBuild, IsSound) {
  Random random(3);
  EXPECT_LE(checkTree(makeTorusKnot(2, 3, 0.3, 200, 30)), 30);
  EXPECT_LE(checkTree(makeSoup(random, 1000, 1, 0.5)), 64);
}

TEST(BvhBuild, HalvesIdenticalTriangles) {
  Mesh mesh = makeBox({1, 1, 1}, 1);
  mesh.triangles.assign(10'000, mesh.triangles[0]);
  EXPECT_EQ(checkTree(mesh), 12);
}

int depthOf(const std::vector<BvhNode>& nodes, std::uint32_t index) {
  const BvhNode& node = nodes[index];
  return node.count > 0 ? 0 : 1 + std::max(depthOf(nodes, node.link), depthOf(nodes, node.link + 1));
}

TEST(BvhBuild, IsNotDeeperThanAsked) {
  Random random(19);
  std::vector<BvhPrimitive> primitives(10'000);
  for (std::uint32_t i = 0; i < primitives.size(); ++i) {
    // Few large ones and many small ones: halves are not what the heuristic likes.
    const auto x = static_cast<float>(std::pow(0.99, i) + random.uniform(0, 1e-3)), size = 0.1f * x;
    primitives[i] = {{x - size, 0, 0}, i, {x + size, size, size}, 0};
  }
  // 10 000 triangles fill 2500 leaves, 2^12 is the next power of two.
  for (const int maxDepth : {12, 13, 20, bvhMaxDepth}) {
    EXPECT_LE(depthOf(buildBinaryTree(primitives, 1, maxDepth), 0), maxDepth);
  }
  EXPECT_GT(depthOf(buildBinaryTree(primitives, 1, bvhMaxDepth), 0), 13);
}

}  // namespace
}  // namespace anamorph
