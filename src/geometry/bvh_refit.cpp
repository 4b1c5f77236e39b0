// Everything in a Bvh that depends on where the points are.

#include <algorithm>
#include <limits>

#include "base/parallel_for.h"
#include "geometry/bvh_build.h"
#include "geometry/bvh_simd.h"

namespace anamorph {
namespace {

/// Boxes grow by this share of the mesh's radius. A slab test works with coordinates of up to 5 radii (see
/// FloatRay) and rounds three times, by 6e-8 each: together less than 1e-6.
constexpr double padding = 2e-6;

struct alignas(16) FloatPoint {
  float x[4];
};

constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();

// Absent points become NaN here, and nowhere else.
std::vector<FloatPoint> copyPoints(BvhData& data, const PointArray& points, int threads,
                                   std::span<const std::uint8_t> absent) {
  std::vector<FloatPoint> floats(points.size());
  parallelFor(points.size(), 16384, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = points[i], q = p - data.centre;
      data.points[i] = {p.x, p.y, p.z, 0};
      floats[i] = {{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), 0}};
      if (!absent.empty() && absent[i] != 0) floats[i] = {{noNumber, noNumber, noNumber, 0}};
    }
  });
  return floats;
}

/// The x, y and z of four points.
void storeTransposed(const Float4 (&p)[4], float* x, float* y, float* z) {
  const Float4 xy01 = __builtin_shufflevector(p[0], p[1], 0, 4, 1, 5);
  const Float4 xy23 = __builtin_shufflevector(p[2], p[3], 0, 4, 1, 5);
  const Float4 zw01 = __builtin_shufflevector(p[0], p[1], 2, 6, 3, 7);
  const Float4 zw23 = __builtin_shufflevector(p[2], p[3], 2, 6, 3, 7);
  store(x, __builtin_shufflevector(xy01, xy23, 0, 1, 4, 5));
  store(y, __builtin_shufflevector(xy01, xy23, 2, 3, 6, 7));
  store(z, __builtin_shufflevector(zw01, zw23, 0, 1, 4, 5));
}

/// The fourth lane of what is loaded from a node's min and max is no coordinate, and is put back after
/// storing.
void storeBox(BvhNode& node, Float4 min, Float4 max) {
  const std::uint32_t link = node.link, count = node.count;
  store(node.min, min);
  store(node.max, max);
  node.link = link;
  node.count = count;
}

/// The corners of a leaf's triangles into its block, and their box into the leaf.
void fillBlock(const std::vector<FloatPoint>& points, Float4 pad, BvhBlock& block, BvhNode& leaf) {
  Float4 min = broadcast(std::numeric_limits<float>::infinity()), max = -min;
  Float4 nothing[4];  // 0, or NaN where the lane has no triangle or one without all its corners
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    nothing[lane] = broadcast(noNumber);
    if (lane >= leaf.count) continue;
    const Float4 sum = load(points[block.point[0][lane]].x) + load(points[block.point[1][lane]].x) +
                       load(points[block.point[2][lane]].x);
    nothing[lane] = sum - sum;
  }
  for (int corner = 0; corner < 3; ++corner) {
    Float4 p[4];
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      p[lane] = nothing[lane];
      if (lane < leaf.count) p[lane] += load(points[block.point[corner][lane]].x);
      // In this order of arguments NaN loses.
      min = minimum(p[lane], min);
      max = maximum(p[lane], max);
    }
    storeTransposed(p, block.corner[corner][0], block.corner[corner][1], block.corner[corner][2]);
  }
  storeBox(leaf, min - pad, max + pad);
}

/// From the last node to the first: children before their parents.
void updateInnerNodes(std::vector<BvhNode>& nodes) {
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].count > 0) continue;
    const BvhNode &left = nodes[nodes[i].link], &right = nodes[nodes[i].link + 1];
    storeBox(nodes[i], minimum(load(left.min), load(right.min)), maximum(load(left.max), load(right.max)));
  }
}

void copyBounds(const std::vector<BvhNode>& nodes, BvhWideNode& wide) {
  const Float4 nothing = broadcast(std::numeric_limits<float>::infinity());
  for (int half = 0; half < BvhWideNode::width; half += 4) {
    Float4 min[4], max[4];
    for (int i = 0; i < 4; ++i) {
      const std::uint32_t source = wide.source[half + i];
      const bool used = source != BvhWideNode::noSource;
      min[i] = used ? load(nodes[source].min) : nothing;
      max[i] = used ? load(nodes[source].max) : -nothing;
    }
    auto& [x, y, z] = wide.bounds;
    storeTransposed(min, x[0] + half, y[0] + half, z[0] + half);
    storeTransposed(max, x[1] + half, y[1] + half, z[1] + half);
  }
}

}  // namespace

void placeFrame(BvhData& data, const PointArray& points, std::span<const std::uint8_t> absent) {
  // A stray point that no triangle uses would cost all others their digits.
  Box box;
  auto unused = data.unusedPoints.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (unused != data.unusedPoints.end() && *unused == i) {
      ++unused;
    } else if (absent.empty() || absent[i] == 0) {
      box.extend(points[i]);
    }
  }
  if (box.empty()) box.extend(Point(0));
  const Vector size = box.size();
  data.centre = box.centre();
  data.radius = 0.5 * std::max({size.x, size.y, size.z});
}

void placePoints(BvhData& data, const PointArray& points, int threads,
                 std::span<const std::uint8_t> absent) {
  const std::vector<FloatPoint> floats = copyPoints(data, points, threads, absent);
  const Float4 pad = broadcast(static_cast<float>(padding * data.radius));
  parallelFor(data.blocks.size(), 2048, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      fillBlock(floats, pad, data.blocks[i], data.nodes[data.blockLeaf[i]]);
    }
  });
  updateInnerNodes(data.nodes);
  parallelFor(data.wideNodes.size(), 1024, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) copyBounds(data.nodes, data.wideNodes[i]);
  });
}

}  // namespace anamorph
