// Bounding volume hierarchy over the triangles of a mesh: which triangle does a ray meet first?
//
// Our own, because three places need the same tree: the CPU tracer, the mirror's shader (a texture of nodes),
// and a web build. Built top-down by binned surface-area heuristic (Wald 2007, "On fast construction of
// SAH-based bounding volume hierarchies"). The CPU walks an 8-wide form of it. Moving the points without
// changing the triangles needs only refit(). Triangles are found in float, without gaps between neighbours
// (Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection"); the hit itself is computed in double
// from the mesh's own points.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/bvh_nodes.h"
#include "geometry/mesh.h"
#include "math/ray.h"

namespace anamorph {

struct BvhHit {
  std::uint32_t triangle = 0;  ///< index into the mesh's triangles
  double t = 0;                ///< distance along the ray
  double u = 0, v = 0;         ///< barycentrics: point = (1 - u - v) a + u b + v c, all three weights in 0..1
};

class Bvh {
 public:
  Bvh() = default;

  /// Copies what it needs. Triangles without area are never hit. Points must be finite. `threads` as for
  /// parallelFor.
  Bvh(const PointArray& points, std::span<const Triangle> triangles, int threads = 1);

  /// New boxes for moved points, as many as it was built from. The tree stays as it is, so rays get slower
  /// the more the shape changes, but never wrong. Triangles with a point i where absent[i] is not 0 are not
  /// there until the next refit; an empty `absent` means that all are.
  void refit(const PointArray& points, int threads = 1, std::span<const std::uint8_t> absent = {});

  /// The first triangle met at tMin < t < tMax, from either side. False when there is none; `hit` is
  /// untouched then.
  bool closestHit(const Ray& ray, BvhHit& hit, double tMin = 0,
                  double tMax = std::numeric_limits<double>::infinity()) const;

  /// The same where a ray must not be moved by as much as float can tell: which triangle it meets is decided in double,
  /// without gaps too. A mirror asks this, a picture need not.
  bool closestExactHit(const Ray& ray, BvhHit& hit, double tMin = 0,
                       double tMax = std::numeric_limits<double>::infinity()) const;

  /// Whether any triangle is met at tMin < t < tMax.
  bool anyHit(const Ray& ray, double tMin = 0, double tMax = std::numeric_limits<double>::infinity()) const;

  /// Whether there are no triangles at all.
  bool empty() const { return data_.nodes.empty(); }

  /// The binary tree, for a shader to walk, at most 64 levels deep; coordinates are relative to centre().
  const std::vector<BvhNode>& nodes() const { return data_.nodes; }

  /// The mesh's triangles in the order of the leaves.
  const std::vector<std::uint32_t>& triangleOrder() const { return data_.order; }

  /// The middle of the mesh's box.
  const Point& centre() const { return data_.centre; }

 private:
  BvhData data_;
};

}  // namespace anamorph
