#include "geometry/bvh.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/parallel_for.h"
#include "geometry/bvh_build.h"

namespace anamorph {
namespace {

std::vector<std::uint32_t> findUnusedPoints(std::size_t points, std::span<const Triangle> triangles) {
  std::vector<bool> used(points);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t corner : t) {
      CHECK(corner < points);
      used[corner] = true;
    }
  }
  std::vector<std::uint32_t> unused;
  for (std::size_t i = 0; i < points; ++i) {
    if (!used[i]) unused.push_back(static_cast<std::uint32_t>(i));
  }
  return unused;
}

BvhPrimitive makePrimitive(const PointArray& points, const Triangle& t, const Point& centre) {
  BvhPrimitive primitive{};
  const auto setAxis = [&](int axis, const std::vector<double>& x) {
    const auto [low, high] = std::minmax({x[t[0]], x[t[1]], x[t[2]]});
    primitive.min[axis] = static_cast<float>(low - centre[axis]);
    primitive.max[axis] = static_cast<float>(high - centre[axis]);
  };
  setAxis(0, points.x);
  setAxis(1, points.y);
  setAxis(2, points.z);
  return primitive;
}

BvhBlock makeBlock(std::span<const Triangle> triangles, std::span<const std::uint32_t> members) {
  BvhBlock block{};
  for (std::size_t lane = 0; lane < members.size(); ++lane) {
    block.triangle[lane] = members[lane];
    for (int corner = 0; corner < 3; ++corner) block.point[corner][lane] = triangles[members[lane]][corner];
  }
  return block;
}

}  // namespace

Bvh::Bvh(const PointArray& points, std::span<const Triangle> triangles, int threads) {
  data_.points.resize(points.size());
  data_.unusedPoints = findUnusedPoints(points.size(), triangles);
  if (triangles.empty()) return;
  placeFrame(data_, points);

  std::vector<BvhPrimitive> primitives(triangles.size());
  parallelFor(primitives.size(), 4096, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      primitives[i] = makePrimitive(points, triangles[i], data_.centre);
      primitives[i].triangle = static_cast<std::uint32_t>(i);
    }
  });
  data_.nodes = buildBinaryTree(primitives, threads);
  for (const BvhPrimitive& primitive : primitives) data_.order.push_back(primitive.triangle);

  BvhWideTree tree = collapseTree(data_.nodes);
  data_.wideNodes = std::move(tree.nodes);
  data_.blockLeaf = std::move(tree.leaves);
  for (const std::uint32_t index : data_.blockLeaf) {
    const BvhNode& leaf = data_.nodes[index];
    data_.blocks.push_back(makeBlock(triangles, {&data_.order[leaf.link], leaf.count}));
  }
  placePoints(data_, points, threads);
}

void Bvh::refit(const PointArray& points, int threads, std::span<const std::uint8_t> absent) {
  CHECK(points.size() == data_.points.size());
  CHECK(absent.empty() || absent.size() == points.size());
  if (empty()) return;
  placeFrame(data_, points, absent);
  placePoints(data_, points, threads, absent);
}

}  // namespace anamorph
