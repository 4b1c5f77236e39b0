// Polygons into triangles by ear clipping (Meisters 1975: every simple polygon has two ears): a corner whose
// triangle lies inside the polygon is cut off until three corners are left. It is done in the plane of the
// polygon, seen along its mean normal (Newell's formula), so that polygons need not be quite flat. Concave
// ones come out right; of a polygon that crosses itself or has no area something sensible is made: always the
// same number of triangles.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh.h"
#include "geometry/mesh_limits.h"

namespace anamorph {

/// Polygons as files have them: the corner indices of all of them in one array, and how many each one has: 0 for
/// one that was left out, so that the others keep their numbers.
struct PolygonSoup {
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> sizes;
  std::size_t empty = 0;                 ///< how many sizes are 0
  std::vector<std::uint32_t> normals{};  ///< of every corner, by its number; empty: none are wanted
};

/// How many triangles they give when no polygon has a corner twice.
inline std::size_t trianglesOf(const PolygonSoup& polygons) {
  return polygons.corners.size() - 2 * (polygons.sizes.size() - polygons.empty);
}

/// More corners in one polygon than this are taken for damage: of awkward ones ear clipping takes quadratic time.
constexpr std::size_t maxPolygonCorners = 100'000;

/// The limit that a polygon of so many corners passes after those read before, in the words of an Error; empty when
/// it passes none.
std::string limitPassedBy(const PolygonSoup& before, std::size_t corners, const MeshLimits& limits);

/// Appends triangles with the polygon's own orientation to `triangles`. Repeated corners in a row are left
/// out first; n >= 3 corners give n - 2 triangles, less those with the same corner twice.
void triangulatePolygon(const PointArray& points, std::span<const std::uint32_t> corners,
                        std::vector<Triangle>& triangles);

/// All polygons but the empty ones, in their order. Their indices must be valid. `normals`: where to put the triangles'
/// corners' normals, of polygons that have such.
std::vector<Triangle> triangulate(const PointArray& points, const PolygonSoup& polygons,
                                  std::vector<Triangle>* normals = nullptr);

}  // namespace anamorph
