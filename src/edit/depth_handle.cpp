#include "edit/depth_handle.h"

#include <cmath>

namespace anamorph {
namespace {

// A square that stands on a corner.
std::vector<Pixel> diamond(const Pixel& centre, double half) {
  return {centre + Pixel(0, -half), centre + Pixel(half, 0), centre + Pixel(0, half),
          centre + Pixel(-half, 0)};
}

}  // namespace

std::optional<GizmoFrame> depthFrame(const VertexRay& ray) {
  if (!ray.mapped() || ray.legs.empty()) return std::nullopt;
  const Point mirror = ray.legs.back().start;
  // Without a mirror the ray goes straight on, to P and beyond.
  const Vector way = ray.bends ? ray.legs.back().direction : ray.original - mirror;
  const double length = glm::length(way);
  if (!isFinite(mirror) || !(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Direction axis = way / length, side = perpendicular(axis);
  return GizmoFrame{mirror, {axis, side, glm::cross(axis, side)}};
}

Gizmo makeDepthHandle(const ViewProjection& projection, const GizmoFrame& frame, const Point& sculpture,
                      double uiScale) {
  constexpr double half = 8, reach = 0.5 * gizmoPixels;  // pixels
  constexpr int rayColor = 3;
  Gizmo gizmo{{}, uiScale};
  const auto at = projection.pixelOf(sculpture);
  const double length = reach * uiScale * projection.unitsPerPixel(sculpture);
  const auto from = projection.pixelOf(sculpture - length * frame.axes[0]),
             to = projection.pixelOf(sculpture + length * frame.axes[0]);
  if (!at || !from || !to || !std::isfinite(at->x) || !std::isfinite(at->y)) return gizmo;
  using Emphasis = GizmoShape::Emphasis;
  gizmo.shapes.push_back({GizmoHandle::x, {*from, *to}, false, rayColor, Emphasis::normal, 0});
  gizmo.shapes.push_back({GizmoHandle::x, diamond(*at, half * uiScale), true, rayColor, Emphasis::normal, 0});
  return gizmo;
}

}  // namespace anamorph
