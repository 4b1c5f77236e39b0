// Mirror surfaces as triangles, for drawing. Hits are always computed on the exact surface instead.

#include "base/check.h"
#include "math/frame.h"
#include "optics/mirror_shapes.h"

namespace anamorph {
namespace {

// A grid of (columns + 1) x (rows + 1) points, point(u, v) with u and v in 0..1.
template <typename PointAt>
Mesh makeGrid(int columns, int rows, const PointAt& pointAt) {
  Mesh mesh;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      mesh.positions.push_back(pointAt(double(i) / columns, double(j) / rows));
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const auto a = static_cast<std::uint32_t>(j * (columns + 1) + i), b = a + 1;
      const auto c = a + static_cast<std::uint32_t>(columns) + 1, d = c + 1;
      mesh.triangles.push_back({a, b, d});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

Mesh surfaceMesh(const PlaneMirror& plane, int) {
  const auto& v = plane.corners;
  Mesh mesh;
  for (const Point& corner : v) mesh.positions.push_back(corner);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

Mesh surfaceMesh(const CylinderMirror& cylinder, int segments) {
  const Direction axis = glm::normalize(cylinder.top - cylinder.bottom);
  const Direction x = perpendicular(axis), y = glm::cross(axis, x);
  return makeGrid(segments, 1, [&](double u, double v) {
    const double angle = 2 * pi * u;
    return glm::mix(cylinder.bottom, cylinder.top, v) +
           cylinder.radius * (std::cos(angle) * x + std::sin(angle) * y);
  });
}

Mesh surfaceMesh(const SphereMirror& sphere, int segments) {
  return makeGrid(segments, (segments + 1) / 2, [&](double u, double v) {
    const double angle = 2 * pi * u, height = pi * (v - 0.5);
    return sphere.centre + sphere.radius * Vector(std::cos(height) * std::cos(angle),
                                                  std::cos(height) * std::sin(angle), std::sin(height));
  });
}

}  // namespace

Mesh tessellate(const MirrorShape& shape, int segments) {
  CHECK(segments >= 3);
  return std::visit([&](const auto& surface) { return surfaceMesh(surface, segments); }, shape);
}

}  // namespace anamorph
