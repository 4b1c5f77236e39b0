// Rays through the 8-wide tree: nearest children first, the others wait on a stack.

#include <bit>

#include "geometry/bvh.h"
#include "geometry/bvh_build.h"
#include "geometry/bvh_ray.h"
#include "geometry/bvh_simd.h"

namespace anamorph {
namespace {

struct Visit {
  float distance;
  std::uint32_t child;
};
// Every level leaves at most seven of its children waiting.
constexpr int stackSize = (BvhWideNode::width - 1) * bvhMaxDepth + 1;

/// Starts to bring what a child stands for into the cache.
ANAMORPH_ALWAYS_INLINE void prefetch(const BvhData& bvh, std::uint32_t child) {
  const bool isLeaf = (child & BvhWideNode::leaf) != 0;
  const auto* first = isLeaf ? reinterpret_cast<const char*>(&bvh.blocks[child ^ BvhWideNode::leaf])
                             : reinterpret_cast<const char*>(&bvh.wideNodes[child]);
  for (int line = 0; line < 4; ++line) __builtin_prefetch(first + 64 * line);
}

/// Most blocks visited are hit, and where its points are is known only now: do not wait for the float test.
ANAMORPH_ALWAYS_INLINE void prefetchPoints(const BvhData& bvh, const BvhBlock& block) {
  for (const auto& lanes : block.point) {
    for (const std::uint32_t point : lanes) __builtin_prefetch(&bvh.points[point]);
  }
}

/// Brings the last `count` entries into the order of falling distance.
ANAMORPH_ALWAYS_INLINE void sortNearestLast(Visit* top, int count) {
  Visit* const bottom = top - count;
  for (Visit* i = bottom + 1; i < top; ++i) {
    const Visit moving = *i;
    Visit* place = i;
    for (; place > bottom && place[-1].distance < moving.distance; --place) *place = place[-1];
    *place = moving;
  }
}

/// The nearest of the children whose bits are set, at least one; the others are put on the stack.
ANAMORPH_ALWAYS_INLINE std::uint32_t chooseNearest(const BvhData& bvh, const BvhWideNode& node,
                                                   unsigned children, const float* distances, Visit*& top) {
  const auto takeNext = [&] {
    const int lane = std::countr_zero(children);
    children &= children - 1;
    return Visit{distances[lane], node.child[lane]};
  };
  // Most often there are one or two.
  const Visit first = takeNext();
  if (children == 0) return first.child;
  prefetch(bvh, first.child);
  const Visit second = takeNext();
  prefetch(bvh, second.child);
  if (children == 0) {
    const bool inOrder = first.distance <= second.distance;
    *top++ = inOrder ? second : first;
    return inOrder ? first.child : second.child;
  }
  *top++ = first;
  *top++ = second;
  int count = 2;
  while (children != 0) {
    *top++ = takeNext();
    prefetch(bvh, top[-1].child);
    ++count;
  }
  sortNearestLast(top, count);
  return (--top)->child;
}

/// What a walk looks for: any triangle, or the nearest one; which are met is decided in float, or in double.
enum class HitRule { any, nearest, exactNearest };

/// Whether the ray meets a triangle of the block before tMax, which becomes the nearest one's distance.
template <HitRule rule>
ANAMORPH_ALWAYS_INLINE bool testBlock(const BvhData& bvh, const BvhBlock& block, const FloatRay& floatRay,
                                      const ShearedRay& shearedRay, const Ray& ray, BvhHit& hit, double tMin,
                                      double& tMax) {
  constexpr bool exact = rule == HitRule::exactNearest;
  prefetchPoints(bvh, block);
  bool found = false;
  unsigned lanes = exact ? mayPassThrough(block, floatRay, static_cast<float>(bvh.radius))
                         : passesThrough(block, floatRay);
  for (; lanes != 0; lanes &= lanes - 1) {
    const int lane = std::countr_zero(lanes);
    const auto corner = [&](int c) {
      const BvhPoint& p = bvh.points[block.point[c][lane]];
      return Point(p.x, p.y, p.z);
    };
    BvhHit candidate{block.triangle[lane]};
    const TriangleCorners corners{corner(0), corner(1), corner(2)};
    if (!(exact ? meetsExactly(shearedRay, corners, candidate)
                : intersectTriangle(ray, corners, candidate))) {
      continue;
    }
    if (!(candidate.t > tMin && candidate.t < tMax)) continue;
    hit = candidate;
    tMax = hit.t;
    found = true;
  }
  return found;
}

namespace everywhere {
using Lanes = FloatPair;
#define ANAMORPH_TARGET
#include "geometry/bvh_walk.inl"
#undef ANAMORPH_TARGET
}  // namespace everywhere

#if defined(ANAMORPH_HAS_AVX2_CODE)
namespace withAvx2 {
using Lanes = Float8;
#define ANAMORPH_TARGET ANAMORPH_AVX2
#include "geometry/bvh_walk.inl"
#undef ANAMORPH_TARGET
}  // namespace withAvx2

const bool hasAvx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2");

template <HitRule rule>
bool walk(const BvhData& bvh, const Ray& ray, BvhHit& hit, double tMin, double tMax) {
  return hasAvx2 ? withAvx2::walk<rule>(bvh, ray, hit, tMin, tMax)
                 : everywhere::walk<rule>(bvh, ray, hit, tMin, tMax);
}
#else
using everywhere::walk;
#endif

// Not a number passes every test of the walk, and what passes everything never ends.
bool canMeetAnything(const Ray& ray) {
  return isFinite(ray.origin) && isFinite(ray.direction) && lengthSquared(ray.direction) > 0;
}

}  // namespace

bool Bvh::closestHit(const Ray& ray, BvhHit& hit, double tMin, double tMax) const {
  return !empty() && canMeetAnything(ray) && walk<HitRule::nearest>(data_, ray, hit, tMin, tMax);
}

bool Bvh::closestExactHit(const Ray& ray, BvhHit& hit, double tMin, double tMax) const {
  return !empty() && canMeetAnything(ray) && walk<HitRule::exactNearest>(data_, ray, hit, tMin, tMax);
}

bool Bvh::anyHit(const Ray& ray, double tMin, double tMax) const {
  BvhHit hit;
  return !empty() && canMeetAnything(ray) && walk<HitRule::any>(data_, ray, hit, tMin, tMax);
}

}  // namespace anamorph
