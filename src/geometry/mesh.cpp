#include "geometry/mesh.h"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace anamorph {
namespace {

struct PointKey {
  std::array<std::uint64_t, 3> bits;
  bool operator==(const PointKey&) const = default;
};

struct PointKeyHash {
  std::size_t operator()(const PointKey& key) const {
    std::uint64_t hash = 0;
    for (const std::uint64_t bits : key.bits) {
      hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    return hash;
  }
};

PointKey keyOf(const Point& p) {
  // + 0.0 makes -0 and 0 the same.
  return {{std::bit_cast<std::uint64_t>(p.x + 0.0), std::bit_cast<std::uint64_t>(p.y + 0.0),
           std::bit_cast<std::uint64_t>(p.z + 0.0)}};
}

}  // namespace

Box boundingBox(const PointArray& points) {
  Box box;
  for (std::size_t i = 0; i < points.size(); ++i) box.extend(points[i]);
  return box;
}

Vector areaVector(const PointArray& points, const Triangle& triangle) {
  const Point a = points[triangle[0]];
  return glm::cross(points[triangle[1]] - a, points[triangle[2]] - a);
}

double signedVolume(const Mesh& mesh) {
  // The sum of the tetrahedra between each triangle and one point; a near point keeps digits.
  if (mesh.positions.empty()) return 0;
  const Point origin = mesh.positions[0];
  double sixfold = 0;
  for (const Triangle& t : mesh.triangles) {
    sixfold += glm::dot(mesh.positions[t[0]] - origin, areaVector(mesh.positions, t));
  }
  return sixfold / 6;
}

bool isClosed(const Mesh& mesh) {
  // Directed edges sorted: closed when each appears once and its reverse appears too.
  std::vector<std::uint64_t> edges;
  edges.reserve(mesh.triangles.size() * 3);
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) edges.push_back(std::uint64_t{t[i]} << 32 | t[(i + 1) % 3]);
  }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end()) return false;
  return !edges.empty() && std::all_of(edges.begin(), edges.end(), [&](std::uint64_t edge) {
    return std::binary_search(edges.begin(), edges.end(), edge << 32 | edge >> 32);
  });
}

WeldedMesh weldPositions(const Mesh& mesh) {
  WeldedMesh welded;
  welded.vertexOf.resize(mesh.positions.size());
  std::unordered_map<PointKey, std::uint32_t, PointKeyHash> seen;
  seen.reserve(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const auto next = static_cast<std::uint32_t>(welded.mesh.positions.size());
    const auto [entry, isNew] = seen.try_emplace(keyOf(mesh.positions[i]), next);
    if (isNew) welded.mesh.positions.push_back(mesh.positions[i]);
    welded.vertexOf[i] = entry->second;
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const Triangle& old = mesh.triangles[i];
    const Triangle t{welded.vertexOf[old[0]], welded.vertexOf[old[1]], welded.vertexOf[old[2]]};
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    welded.mesh.triangles.push_back(t);
    welded.triangleOf.push_back(static_cast<std::uint32_t>(i));
  }
  return welded;
}

Mesh unitize(Mesh mesh) {
  const Box box = boundingBox(mesh.positions);
  if (box.empty()) return mesh;
  const Vector size = box.size();
  const double longest = std::max({size.x, size.y, size.z});
  const double unit = longest > 0 ? longest : 1;  // divided by: 1 / longest would overflow for the tiniest meshes
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return (p - box.centre()) / unit; });
  return mesh;
}

}  // namespace anamorph
