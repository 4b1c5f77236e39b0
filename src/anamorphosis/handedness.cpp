#include "anamorphosis/handedness.h"

#include <algorithm>
#include <array>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace anamorph {
namespace {

constexpr std::size_t enough = 64;  // triangles

// As large as the triangle seems from the eye; negative where the bundle is turned around.
double orientation(const VertexMap& map, const PointArray& original, const Triangle& triangle) {
  std::array<Direction, 3> sent, onward;
  std::array<Point, 3> exit;
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector towards = original[triangle[i]] - map.eye;
    const OpticPath path = followRay(map.optic, {map.eye, towards});
    if (path.pointCount == 0) return 0;
    const double length = glm::length(towards);
    sent[i] = towards / length;
    onward[i] = glm::normalize(path.exit.direction);
    exit[i] = path.exit.origin;
    distance += exitLength(map, path, towards) * length / 3;
  }
  const auto edge = [&](std::size_t i) { return exit[i] - exit[0] + distance * (onward[i] - onward[0]); };
  const double spread = glm::dot(glm::cross(edge(1), edge(2)), onward[0] + onward[1] + onward[2]);
  const double atEye = glm::determinant(glm::dmat3(sent[0], sent[1], sent[2]));
  return spread > 0 ? atEye : spread < 0 ? -atEye : 0;
}

}  // namespace

bool reversesHandedness(const VertexMap& map, const PointArray& original,
                        const std::vector<Triangle>& triangles, const std::vector<PathStatus>& status) {
  const auto mapped = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return status[v] == PathStatus::mapped; });
  };
  double same = 0, reversed = 0;
  std::size_t asked = 0;
  // Evenly over the list first; where little is mapped, one after the other.
  for (const std::size_t stride : {std::max<std::size_t>(1, triangles.size() / enough), std::size_t{1}}) {
    for (std::size_t i = 0; i < triangles.size() && asked < enough; i += stride) {
      if (!mapped(triangles[i])) continue;
      const double seen = orientation(map, original, triangles[i]);
      (seen < 0 ? reversed : same) += std::abs(seen);
      ++asked;
    }
    if (asked > 0) break;
  }
  return reversed > same;
}

}  // namespace anamorph
