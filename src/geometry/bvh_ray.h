// One ray against one block of triangles: first in float, which of them the ray passes through, then in
// double, where.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/bvh.h"
#include "geometry/bvh_simd.h"

namespace anamorph {

/// A ray in the tree's coordinates, with what the tests of boxes and triangles need of it.
struct FloatRay {
  float origin[3], inverse[3];  ///< for boxes
  int nearSide[3];              ///< which of min and max the ray meets first
  // For triangles: the axes are renamed so that z is the one the ray runs along most, and x and y are sheared
  // so that the ray becomes the z axis (Woop et al. 2013). What remains is whether the origin lies in a plane
  // triangle.
  int x, y, z;
  float shearX, shearY;
  double shift;  ///< its parameter is the original ray's minus this
};

/// Far rays start where they are nearest to the centre instead, so that float coordinates stay below 5 radii
/// where there is anything to meet.
inline double shiftOf(const Ray& ray, const Vector& toOrigin, double radius) {
  const double far = std::max({std::abs(toOrigin.x), std::abs(toOrigin.y), std::abs(toOrigin.z)});
  return far > 4 * radius ? -glm::dot(toOrigin, ray.direction) / lengthSquared(ray.direction) : 0;
}

ANAMORPH_ALWAYS_INLINE FloatRay makeFloatRay(const Ray& ray, const Point& centre, double radius) {
  FloatRay r;
  const Vector toOrigin = ray.origin - centre;
  r.shift = shiftOf(ray, toOrigin, radius);
  const Vector origin = toOrigin + r.shift * ray.direction;
  float direction[3];
  for (int axis = 0; axis < 3; ++axis) {
    r.origin[axis] = static_cast<float>(origin[axis]);
    direction[axis] = static_cast<float>(ray.direction[axis]);
    // Infinite for 0. Where the origin lies exactly on the plane of a side, 0 * infinity is no number and the slab
    // test lets the box pass: a box too many is looked at, none too few.
    r.inverse[axis] = 1 / direction[axis];
    r.nearSide[axis] = r.inverse[axis] < 0;
  }
  const float ax = std::abs(direction[0]), ay = std::abs(direction[1]), az = std::abs(direction[2]);
  r.z = az >= ax && az >= ay ? 2 : ay >= ax ? 1 : 0;
  r.x = r.z == 2 ? 0 : r.z + 1;
  r.y = r.x == 2 ? 0 : r.x + 1;
  r.shearX = direction[r.x] / direction[r.z];
  r.shearY = direction[r.y] / direction[r.z];
  return r;
}

/// The corners of a block's triangles, seen along the ray.
struct ShearedBlock {
  Float4 x[3], y[3];
};

ANAMORPH_ALWAYS_INLINE ShearedBlock shearBlock(const BvhBlock& block, const FloatRay& r) {
  ShearedBlock sheared;
  for (int c = 0; c < 3; ++c) {
    const Float4 z = load(block.corner[c][r.z]) - broadcast(r.origin[r.z]);
    sheared.x[c] = load(block.corner[c][r.x]) - broadcast(r.origin[r.x]) - broadcast(r.shearX) * z;
    sheared.y[c] = load(block.corner[c][r.y]) - broadcast(r.origin[r.y]) - broadcast(r.shearY) * z;
  }
  return sheared;
}

/// Which triangles the line of the ray passes through; one bit a lane.
ANAMORPH_ALWAYS_INLINE unsigned passesThrough(const BvhBlock& block, const FloatRay& r) {
  const auto [x, y] = shearBlock(block, r);
  // Twice the areas between origin and edges. Neighbours get the same number with the other sign for their
  // common edge (the products round alike), so no ray passes between them; 0 belongs to both.
  const Float4 a = x[2] * y[1] - x[1] * y[2];
  const Float4 b = x[0] * y[2] - x[2] * y[0];
  const Float4 c = x[1] * y[0] - x[0] * y[1];
  const Float4 least = minimum(minimum(a, b), c), most = maximum(maximum(a, b), c);
  const Float4 zero{};
  // All 0 is a triangle seen edge-on.
  return laneMask(((least >= zero) & (most > zero)) | ((most <= zero) & (least < zero)));
}

/// The same for a test in double that follows: none is left out that this could find, for all roundings of the float
/// test. Those of a coordinate stay below 2^-19 radii, as far rays start near the centre.
ANAMORPH_ALWAYS_INLINE unsigned mayPassThrough(const BvhBlock& block, const FloatRay& r, float radius) {
  const auto [x, y] = shearBlock(block, r);
  const Float4 a = x[2] * y[1] - x[1] * y[2];
  const Float4 b = x[0] * y[2] - x[2] * y[0];
  const Float4 c = x[1] * y[0] - x[0] * y[1];
  const Float4 least = minimum(minimum(a, b), c), most = maximum(maximum(a, b), c);
  Float4 reach{};
  for (int i = 0; i < 3; ++i) reach += maximum(x[i], -x[i]) + maximum(y[i], -y[i]);
  const Float4 error = broadcast(radius * 0x1p-18f), slack = error * (reach + error);
  return laneMask((least >= -slack) | (most <= slack));
}

struct TriangleCorners {
  Point a, b, c;
};

/// The float test found this triangle, in double the ray just misses it: a point of the triangle nearby.
inline void clampToTriangle(const Ray& ray, const TriangleCorners& corners, BvhHit& hit) {
  hit.u = hit.u >= 0 ? std::min(hit.u, 1.0) : 0;
  hit.v = hit.v >= 0 ? std::min(hit.v, 1 - hit.u) : 0;
  // A triangle seen edge-on would otherwise be met anywhere.
  const auto depth = [&](const Point& p) {
    return glm::dot(p - ray.origin, ray.direction) / lengthSquared(ray.direction);
  };
  const auto [nearest, farthest] = std::minmax({depth(corners.a), depth(corners.b), depth(corners.c)});
  hit.t = hit.t >= nearest ? std::min(hit.t, farthest) : nearest;
}

/// Where the ray meets the triangle's plane, kept within the triangle. False when that has no area.
ANAMORPH_ALWAYS_INLINE bool intersectTriangle(const Ray& ray, const TriangleCorners& corners, BvhHit& hit) {
  const Vector ab = corners.b - corners.a, ac = corners.c - corners.a, normal = glm::cross(ab, ac);
  if (normal == Vector(0)) return false;
  const Vector toA = corners.a - ray.origin, side = glm::cross(toA, ray.direction);
  const double inverse = 1 / glm::dot(normal, ray.direction);
  hit.t = glm::dot(normal, toA) * inverse;
  hit.u = glm::dot(side, ac) * inverse;
  hit.v = -glm::dot(side, ab) * inverse;
  const bool inside = hit.u >= 0 && hit.v >= 0 && hit.v <= 1 - hit.u;
  if (!inside) clampToTriangle(ray, corners, hit);
  return true;
}

/// A ray as the test of triangles in double needs it, see FloatRay.
struct ShearedRay {
  explicit ShearedRay(const Ray& ray, const FloatRay& r)
      : origin(ray.origin),
        x(r.x),
        y(r.y),
        z(r.z),
        shearX(ray.direction[x] / ray.direction[z]),
        shearY(ray.direction[y] / ray.direction[z]),
        along(ray.direction[z]) {}

  Point origin;
  int x, y, z;
  double shearX, shearY, along;
};

/// passesThrough() in double, and where: neighbours agree on their common edge, so no ray gets lost between them.
ANAMORPH_ALWAYS_INLINE bool meetsExactly(const ShearedRay& r, const TriangleCorners& corners, BvhHit& hit) {
  const auto sheared = [&](const Point& p) {
    const Vector v = p - r.origin;
    return Vector(v[r.x] - r.shearX * v[r.z], v[r.y] - r.shearY * v[r.z], v[r.z]);
  };
  const Vector p = sheared(corners.a), q = sheared(corners.b), s = sheared(corners.c);
  const double a = s.x * q.y - q.x * s.y, b = p.x * s.y - s.x * p.y, c = q.x * p.y - p.x * q.y;
  const auto [least, most] = std::minmax({a, b, c});
  if (!((least >= 0 && most > 0) || (most <= 0 && least < 0))) return false;
  const double sum = a + b + c;
  hit.u = b / sum;
  hit.v = c / sum;
  hit.t = (a * p.z + b * q.z + c * s.z) / (sum * r.along);
  return true;
}

}  // namespace anamorph
