#include "geometry/mesh_assembly.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace anamorph {
namespace {

constexpr Remark atBadVertex{"1 face at an unusable vertex left out",
                             "{} faces at an unusable vertex left out"};
constexpr Remark twiceTheSame{"1 face of fewer than three different corners left out",
                              "{} faces of fewer than three different corners left out"};
constexpr Remark unusedVertices{"1 vertex that no face uses left out",
                                "{} vertices that no face uses left out"};

bool isNoVertex(double x) {
  return std::isnan(x);
}

// Calls `keep(polygon, corners)` for every polygon that is not empty, and empties those that it says no to.
template <typename Keep>
void keepPolygons(PolygonSoup& polygons, const Keep& keep) {
  std::vector<std::uint32_t>&corners = polygons.corners, &normals = polygons.normals;
  std::size_t to = 0, from = 0;
  for (std::size_t i = 0; i < polygons.sizes.size(); ++i) {
    const std::uint32_t size = polygons.sizes[i];
    if (size == 0) continue;
    if (keep(i, std::span<const std::uint32_t>(&corners[from], size))) {
      std::copy_n(&corners[from], size, &corners[to]);
      if (!normals.empty()) std::copy_n(&normals[from], size, &normals[to]);
      to += size;
    } else {
      polygons.sizes[i] = 0;
      ++polygons.empty;
    }
    from += size;
  }
  corners.resize(to);
  if (!normals.empty()) normals.resize(to);
}

void leaveOutUnusable(const PointArray& positions, PolygonSoup& polygons, const FileCounting& counting,
                      MeshRemarks& remarks) {
  const std::size_t count = positions.size();
  const auto isBeyond = [&](std::uint32_t corner) { return corner >= count; };
  const auto isBad = [&](std::uint32_t corner) { return isNoVertex(positions.x[corner]); };
  const auto& all = polygons.corners;
  if (std::none_of(all.begin(), all.end(), isBeyond) &&
      std::none_of(positions.x.begin(), positions.x.end(), isNoVertex)) {
    return;
  }
  keepPolygons(polygons, [&](std::size_t face, std::span<const std::uint32_t> corners) {
    const auto beyond = std::find_if(corners.begin(), corners.end(), isBeyond);
    if (beyond != corners.end()) {
      remarks.add(badIndices, [&] {
        return RemarkPlace{counting.whereIsFace(face),
                           fmt::format("expected vertex indices up to {}, got {}",
                                       count + counting.firstVertex - 1, *beyond + counting.firstVertex)};
      });
      return false;
    }
    if (std::none_of(corners.begin(), corners.end(), isBad)) return true;
    remarks.add(atBadVertex, [&] { return RemarkPlace{counting.whereIsFace(face), {}}; });
    return false;
  });
}

// Polygons that give no triangle, when there are any.
void remarkDegenerate(const PointArray& positions, PolygonSoup& polygons, const FileCounting& counting,
                      MeshRemarks& remarks) {
  std::vector<Triangle> triangles;
  keepPolygons(polygons, [&](std::size_t face, std::span<const std::uint32_t> corners) {
    triangles.clear();
    triangulatePolygon(positions, corners, triangles);
    if (!triangles.empty()) return true;
    remarks.add(twiceTheSame, [&] {
      return RemarkPlace{counting.whereIsFace(face), "expected at least three different corners"};
    });
    return false;
  });
}

}  // namespace

Point noVertex() {
  return Point(std::numeric_limits<double>::quiet_NaN());
}

Mesh assembleMesh(PointArray positions, PolygonSoup polygons, const FileCounting& counting,
                  MeshRemarks& remarks, std::vector<Triangle>* normals) {
  leaveOutUnusable(positions, polygons, counting, remarks);
  Mesh mesh;
  mesh.triangles = triangulate(positions, polygons, normals);
  if (mesh.triangles.size() < trianglesOf(polygons)) {
    remarkDegenerate(positions, polygons, counting, remarks);
  }
  mesh.positions = std::move(positions);
  if (mesh.triangles.empty()) return mesh;
  leaveOutUnusedVertices(mesh, [&](std::size_t vertex) {
    if (isNoVertex(mesh.positions.x[vertex])) return;
    remarks.add(unusedVertices, [&] {
      return RemarkPlace{fmt::format("vertex {}", vertex + counting.firstVertex), {}};
    });
  });
  return mesh;
}

void leaveOutUnusedVertices(Mesh& mesh, const std::function<void(std::size_t)>& tell) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> newIndex(mesh.positions.size(), unused);
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) newIndex[corner] = 0;
  }
  if (std::find(newIndex.begin(), newIndex.end(), unused) == newIndex.end()) return;
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < newIndex.size(); ++i) {
    if (newIndex[i] != unused) {
      mesh.positions.set(next, mesh.positions[i]);
      newIndex[i] = next++;
    } else if (tell) {
      tell(i);
    }
  }
  mesh.positions.resize(next);
  for (Triangle& t : mesh.triangles) t = {newIndex[t[0]], newIndex[t[1]], newIndex[t[2]]};
}

}  // namespace anamorph
