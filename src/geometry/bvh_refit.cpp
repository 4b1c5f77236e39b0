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

std::vector<FloatPoint> copyPoints(BvhData& data, const PointArray& points, int threads) {
  std::vector<FloatPoint> floats(points.size());
  parallelFor(points.size(), 16384, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Point p = points[i], q = p - data.centre;
      data.points[i] = {p.x, p.y, p.z, 0};
      floats[i] = {{static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z), 0}};
    }
  });
  return floats;
}

/// The corners of a leaf's triangles into its block, and their box into the leaf.
void fillBlock(const std::vector<FloatPoint>& points, float pad, BvhBlock& block, BvhNode& leaf) {
  Float4 min = broadcast(std::numeric_limits<float>::infinity()), max = -min;
  for (std::uint32_t lane = 0; lane < leaf.count; ++lane) {
    for (int corner = 0; corner < 3; ++corner) {
      const Float4 p = load(points[block.point[corner][lane]].x);
      for (int axis = 0; axis < 3; ++axis) block.corner[corner][axis][lane] = p[axis];
      min = minimum(min, p);
      max = maximum(max, p);
    }
  }
  for (int axis = 0; axis < 3; ++axis) {
    leaf.min[axis] = min[axis] - pad;
    leaf.max[axis] = max[axis] + pad;
  }
}

/// From the last node to the first: children before their parents.
void updateInnerNodes(std::vector<BvhNode>& nodes) {
  for (std::size_t i = nodes.size(); i-- > 0;) {
    BvhNode& node = nodes[i];
    if (node.count > 0) continue;
    const BvhNode &left = nodes[node.link], &right = nodes[node.link + 1];
    for (int axis = 0; axis < 3; ++axis) {
      node.min[axis] = std::min(left.min[axis], right.min[axis]);
      node.max[axis] = std::max(left.max[axis], right.max[axis]);
    }
  }
}

void copyBounds(const std::vector<BvhNode>& nodes, BvhWideNode& wide) {
  for (int child = 0; child < BvhWideNode::width; ++child) {
    if (wide.source[child] == BvhWideNode::noSource) continue;
    const BvhNode& source = nodes[wide.source[child]];
    for (int axis = 0; axis < 3; ++axis) {
      wide.bounds[axis][0][child] = source.min[axis];
      wide.bounds[axis][1][child] = source.max[axis];
    }
  }
}

}  // namespace

void placeFrame(BvhData& data, const PointArray& points) {
  // A stray point that no triangle uses would cost all others their digits.
  Box box;
  auto unused = data.unusedPoints.begin();
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (unused != data.unusedPoints.end() && *unused == i) {
      ++unused;
    } else {
      box.extend(points[i]);
    }
  }
  const Vector size = box.size();
  data.centre = box.centre();
  data.radius = 0.5 * std::max({size.x, size.y, size.z});
}

void placePoints(BvhData& data, const PointArray& points, int threads) {
  const std::vector<FloatPoint> floats = copyPoints(data, points, threads);
  const auto pad = static_cast<float>(padding * data.radius);
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
