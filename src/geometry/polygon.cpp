#include "geometry/polygon.h"

#include <fmt/format.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>

#include "base/check.h"
#include "geometry/corner_grid.h"

namespace anamorph {
namespace {

// Twice the signed area of the triangle: positive when counter-clockwise.
double orientation(const Point2& a, const Point2& b, const Point2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// Twice the area vector of the polygon.
Vector newellNormal(const PointArray& points, std::span<const std::uint32_t> corners) {
  Vector normal{0};
  const Point origin = points[corners[0]];
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    normal += glm::cross(points[corners[i]] - origin, points[corners[i + 1]] - origin);
  }
  return normal;
}

// The polygon seen from its front, counter-clockwise: the axis nearest to the normal is left out, which
// unlike a rotation changes no digit of the coordinates.
std::vector<Point2> project(const PointArray& points, std::span<const std::uint32_t> corners) {
  const Vector normal = newellNormal(points, corners);
  const Vector size = glm::abs(normal);
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  int right = (axis + 1) % 3, up = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(right, up);
  std::vector<Point2> flat;
  flat.reserve(corners.size());
  for (const std::uint32_t corner : corners) {
    const Point p = points[corner];
    flat.emplace_back(p[right], p[up]);
  }
  return flat;
}

// A polygon may come back to a corner that it had before.
void appendTriangle(const Triangle& t, std::vector<Triangle>& triangles) {
  if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) triangles.push_back(t);
}

// The corners that are not cut off yet, as a ring.
class EarClipper {
 public:
  EarClipper(std::span<const std::uint32_t> corners, std::vector<Point2> flat)
      : corners_(corners), flat_(std::move(flat)), next_(corners.size()), previous_(corners.size()) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      next_[i] = (i + 1) % corners_.size();
      previous_[next_[i]] = i;
    }
    std::vector<std::size_t> reflex;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      if (!isConvex(i)) reflex.push_back(i);
    }
    reflex_ = CornerGrid(flat_, reflex);
  }

  void clipAll(std::vector<Triangle>& triangles) {
    std::size_t corner = 1;
    std::size_t failures = 0;
    for (std::size_t left = corners_.size(); left > 3; --left) {
      while (failures < left && !isEar(corner)) {
        corner = next_[corner];
        ++failures;
      }
      // A whole round without an ear: the polygon is not simple, and any corner is as good as another.
      if (failures < left) failures = 0;
      appendTriangle(triangleAt(corner), triangles);
      cutOff(corner);
      // Every other corner is tried first, which makes better triangles than a fan.
      corner = failures == 0 ? next_[next_[corner]] : next_[corner];
    }
    appendTriangle(triangleAt(corner), triangles);
  }

 private:
  Triangle triangleAt(std::size_t i) const {
    return {corners_[previous_[i]], corners_[i], corners_[next_[i]]};
  }

  bool isConvex(std::size_t i) const {
    return orientation(flat_[previous_[i]], flat_[i], flat_[next_[i]]) > 0;
  }

  // Only a corner that is not convex can be the first to reach into the triangle.
  bool isEar(std::size_t i) const {
    if (!isConvex(i)) return false;
    const Point2 a = flat_[previous_[i]], b = flat_[i], c = flat_[next_[i]];
    return reflex_.noneIn({a, b, c}, [&](std::size_t other) {
      const Point2 p = flat_[other];
      // Corners in the same place (a polygon with a slit to a hole) do not block each other.
      if (p == a || p == b || p == c) return false;
      return orientation(a, b, p) >= 0 && orientation(b, c, p) >= 0 && orientation(c, a, p) >= 0;
    });
  }

  void cutOff(std::size_t i) {
    const std::size_t before = previous_[i], after = next_[i];
    next_[before] = after;
    previous_[after] = before;
    reflex_.remove(i, flat_[i]);
    for (const std::size_t other : {before, after}) {
      if (isConvex(other)) reflex_.remove(other, flat_[other]);
    }
  }

  std::span<const std::uint32_t> corners_;
  std::vector<Point2> flat_;
  std::vector<std::size_t> next_, previous_;
  CornerGrid reflex_;  // the corners that are not convex
};

// Of a polygon's triangles: the normals of its own corners, the first of each.
void appendNormals(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> normals,
                   std::span<const Triangle> triangles, std::vector<Triangle>& to) {
  std::unordered_map<std::uint32_t, std::uint32_t> normalAt;
  for (std::size_t i = 0; i < corners.size(); ++i) normalAt.try_emplace(corners[i], normals[i]);
  for (const Triangle& t : triangles) to.push_back({normalAt.at(t[0]), normalAt.at(t[1]), normalAt.at(t[2])});
}

}  // namespace

std::string limitPassedBy(const PolygonSoup& before, std::size_t corners, const MeshLimits& limits) {
  if (corners > maxPolygonCorners) {
    return fmt::format("expected at most {} corners, got {}", maxPolygonCorners, corners);
  }
  if (trianglesOf(before) + corners - 2 > limits.maxTriangles()) return limits.tooManyTriangles();
  return {};
}

void triangulatePolygon(const PointArray& points, std::span<const std::uint32_t> corners,
                        std::vector<Triangle>& triangles) {
  CHECK(corners.size() <= maxPolygonCorners);
  std::vector<std::uint32_t> ring(corners.begin(), corners.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  if (ring.size() < 3) return;
  EarClipper(ring, project(points, ring)).clipAll(triangles);
}

std::vector<Triangle> triangulate(const PointArray& points, const PolygonSoup& polygons,
                                  std::vector<Triangle>* normals) {
  std::vector<Triangle> triangles;
  triangles.reserve(trianglesOf(polygons));
  std::size_t first = 0;
  for (const std::uint32_t size : polygons.sizes) {
    const std::span corners(polygons.corners.data() + first, size);
    const std::size_t before = triangles.size();
    if (size == 3) {  // nearly always
      appendTriangle({corners[0], corners[1], corners[2]}, triangles);
    } else {
      triangulatePolygon(points, corners, triangles);
    }
    if (normals) {
      appendNormals(corners, {polygons.normals.data() + first, size}, std::span(triangles).subspan(before),
                    *normals);
    }
    first += size;
  }
  return triangles;
}

}  // namespace anamorph
