#include "geometry/lathe.h"

#include <cmath>

#include "base/check.h"

namespace anamorph {
namespace {

std::vector<glm::dvec2> directionsAround(int segments) {
  std::vector<glm::dvec2> directions;
  for (int i = 0; i < segments; ++i) {
    const double angle = 2 * pi * i / segments;
    directions.emplace_back(std::cos(angle), std::sin(angle));
  }
  return directions;
}

void addRing(PointArray& points, const glm::dvec2& profilePoint, const std::vector<glm::dvec2>& directions) {
  for (const glm::dvec2& d : directions) {
    points.push_back({profilePoint.x * d.x, profilePoint.x * d.y, profilePoint.y});
  }
}

}  // namespace

Mesh makeLathe(std::span<const glm::dvec2> profile, int segments) {
  CHECK(segments >= 3 && profile.size() >= 3);
  const auto around = directionsAround(segments);
  const auto rings = static_cast<std::uint32_t>(profile.size() - 2);
  const auto count = static_cast<std::uint32_t>(segments);
  const std::uint32_t bottom = 0, top = rings * count + 1;
  const auto vertex = [&](std::uint32_t ring, std::uint32_t i) { return 1 + ring * count + i % count; };

  Mesh mesh;
  mesh.positions.push_back({0, 0, profile.front().y});
  for (const glm::dvec2& p : profile.subspan(1, rings)) addRing(mesh.positions, p, around);
  mesh.positions.push_back({0, 0, profile.back().y});

  for (std::uint32_t i = 0; i < count; ++i)
    mesh.triangles.push_back({bottom, vertex(0, i + 1), vertex(0, i)});
  for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::uint32_t a = vertex(ring, i), b = vertex(ring, i + 1);
      const std::uint32_t c = vertex(ring + 1, i + 1), d = vertex(ring + 1, i);
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.triangles.push_back({vertex(rings - 1, i), vertex(rings - 1, i + 1), top});
  return mesh;
}

}  // namespace anamorph
