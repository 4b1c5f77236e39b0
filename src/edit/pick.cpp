#include "edit/pick.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "edit/camera_body.h"

namespace anamorph {
namespace {

constexpr PickedPoint cornerOf(std::uint32_t triangle, int corner) {
  return {triangle, corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0};
}

int nearestCorner(const PointArray& points, const Triangle& triangle, const Point& p) {
  int nearest = 0;
  for (int i = 1; i < 3; ++i) {
    const auto distance = [&](int corner) {
      return lengthSquared(points[triangle[static_cast<std::size_t>(corner)]] - p);
    };
    if (distance(i) < distance(nearest)) nearest = i;
  }
  return nearest;
}

void takeNearer(Pick& best, const Pick& other) {
  if (other.distance < best.distance) best = other;
}

// ---- Icons

Pick pickIcon(const PickInput& input, const Pixel& pixel) {
  Pick best;
  double nearest = iconPixels * input.uiScale;
  const auto consider = [&](const Selection& selection, const Point& point) {
    const auto seen = input.projection.pixelOf(point);
    if (!seen || !(glm::length(*seen - pixel) <= nearest)) return;
    nearest = glm::length(*seen - pixel);
    const Ray ray = input.projection.rayThrough(*seen);
    best = {selection, {}, {}, glm::dot(point - ray.origin, ray.direction), point};
  };
  if (input.display.lightMarkers) {
    for (std::size_t i = 0; i < input.level.lights.size(); ++i) {
      consider({Part::light, static_cast<int>(i)}, input.level.lights[i].position);
    }
  }
  if (input.display.rtCamera) {
    const bool chosen = input.selection.part == Part::eye || input.selection.part == Part::aim;
    if (chosen) consider({Part::aim}, input.level.camera.target);
    consider({Part::eye}, input.level.camera.eye);
  }
  if (input.display.mirror && isOfMirror(input.selection) && !findShapeProblem(input.level.optic.shape())) {
    int number = 0;
    for (const ControlPoint& control : controlPointsOf(input.level.optic.shape())) {
      consider({Part::controlPoint, number++}, control.at);
    }
  }
  return best;
}

// ---- Surfaces

Pick pickGrid(const PickInput& input, const Ray& ray) {
  if (!input.display.rtCamera) return {};
  const auto hit = intersectGrid(input.level.camera, input.level.grid, ray);
  return hit ? Pick{{Part::eye}, hit->cell, {}, hit->t, ray.at(hit->t)} : Pick{};
}

// The body that is drawn behind the eye.
Pick pickCamera(const PickInput& input, const Ray& ray) {
  if (!input.display.rtCamera) return {};
  const double radius = measureScene(boxOf(makeReflectionScene(input.level, input.sculpture))).radius;
  const auto t = intersectRtCamera(input.level.camera, rtCameraSize(input.level.grid, radius), ray);
  return t ? Pick{{Part::eye}, {}, {}, *t, ray.at(*t)} : Pick{};
}

// While it is dragged a sculpture keeps triangles with corners that are not mapped; they are not drawn.
Pick pickSculpture(const PickInput& input, const Ray& ray) {
  const PreparedSculpture& made = input.sculpture;
  if (!input.display.sculpture || !made.sculpture || !made.prepared.bvh || !made.prepared.mesh) return {};
  const Sculpture& sculpture = *made.sculpture;
  const Mesh& mesh = *made.prepared.mesh;
  const auto drawn = [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return sculpture.status[v] == PathStatus::mapped; });
  };
  BvhHit hit;
  double from = 0;
  for (int layer = 0; layer < 64 && made.prepared.bvh->closestHit(ray, hit, from); ++layer) {
    const Triangle& triangle = mesh.triangles[hit.triangle];
    if (drawn(triangle)) {
      const Point where = ray.at(hit.t);
      const std::uint32_t vertex =
          triangle[static_cast<std::size_t>(nearestCorner(mesh.positions, triangle, where))];
      const VertexSource& source = sculpture.source[vertex];
      return {{Part::sculpture}, {}, PickedPoint{source.triangle, source.u, source.v}, hit.t, where};
    }
    from = hit.t;
  }
  return {};
}

Pick pickOriginal(const PickInput& input, const Ray& ray) {
  if (input.display.originalLook == OriginalLook::hidden || !input.original.bvh || !input.original.mesh)
    return {};
  BvhHit hit;
  if (!input.original.bvh->closestHit(ray, hit)) return {};
  const Mesh& mesh = *input.original.mesh;
  const Point where = ray.at(hit.t);
  const int corner = nearestCorner(mesh.positions, mesh.triangles[hit.triangle], where);
  return {{Part::original}, {}, cornerOf(hit.triangle, corner), hit.t, where};
}

// The original's vertex that is seen nearest to the pixel: who aims at a corner often clicks just beside it.
Pick pickVertexBeside(const PickInput& input, const Pixel& pixel) {
  if (input.display.originalLook == OriginalLook::hidden || !input.original.mesh) return {};
  const Mesh& mesh = *input.original.mesh;
  double nearest = vertexPixels * input.uiScale;
  std::optional<std::uint32_t> found;
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    const auto seen = input.projection.pixelOf(mesh.positions[i]);
    if (!seen || !(glm::length(*seen - pixel) <= nearest)) continue;
    nearest = glm::length(*seen - pixel);
    found = i;
  }
  const auto point = found ? pickedVertex(mesh, *found) : std::nullopt;
  if (!point) return {};
  const Point where = mesh.positions[*found];
  const Ray ray = input.projection.rayThrough(pixel);
  return {{Part::original}, {}, point, glm::dot(where - ray.origin, ray.direction), where};
}

Pick pickMirror(const PickInput& input, const Ray& ray) {
  const Shape& shape = input.level.optic.shape();
  if (!input.display.mirror || findShapeProblem(shape)) return {};
  const auto hit = intersect(shape, ray);
  return hit ? Pick{{Part::mirror}, {}, {}, hit->t, hit->point} : Pick{};
}

}  // namespace

Pick pick(const PickInput& input, const Pixel& pixel) {
  const Ray ray = input.projection.rayThrough(pixel);
  if (!isFinite(ray.origin) || !isFinite(ray.direction)) return {};
  const Pick icon = pickIcon(input, pixel);
  if (icon.selection.part != Part::none) return icon;
  Pick best = pickOriginal(input, ray);
  takeNearer(best, pickGrid(input, ray));
  takeNearer(best, pickCamera(input, ray));
  takeNearer(best, pickSculpture(input, ray));
  if (best.selection.part == Part::none) best = pickVertexBeside(input, pixel);
  const bool ghost =
      best.selection.part == Part::original && input.display.originalLook == OriginalLook::ghost;
  if (!ghost) takeNearer(best, pickMirror(input, ray));
  return best;
}

std::optional<GridHit> intersectGrid(const Camera& camera, const PixelGrid& grid, const Ray& ray) {
  const Projection image(camera, std::max(grid.columns, 1), std::max(grid.rows, 1));
  const Direction& forward = image.frame().forward;
  const double t =
      glm::dot(camera.eye + grid.distance * forward - ray.origin, forward) / glm::dot(ray.direction, forward);
  if (!(t > 0) || !std::isfinite(t)) return std::nullopt;
  const auto pixel = image.pixelOf(ray.at(t));
  if (!pixel || !(pixel->x >= 0 && pixel->x < image.width() && pixel->y >= 0 && pixel->y < image.height())) {
    return std::nullopt;
  }
  return GridHit{{static_cast<int>(pixel->x), static_cast<int>(pixel->y)}, t};
}

bool isOn(const Mesh& original, const PickedPoint& picked) {
  return picked.triangle < original.triangles.size();
}

Point pointOn(const Mesh& placedOriginal, const PickedPoint& picked) {
  CHECK(isOn(placedOriginal, picked));
  const Triangle& t = placedOriginal.triangles[picked.triangle];
  const PointArray& p = placedOriginal.positions;
  return (1 - picked.u - picked.v) * p[t[0]] + picked.u * p[t[1]] + picked.v * p[t[2]];
}

std::optional<PickedPoint> pickedVertex(const Mesh& original, std::uint32_t vertex) {
  for (std::uint32_t t = 0; t < original.triangles.size(); ++t) {
    for (int corner = 0; corner < 3; ++corner) {
      if (original.triangles[t][static_cast<std::size_t>(corner)] == vertex) return cornerOf(t, corner);
    }
  }
  return std::nullopt;
}

}  // namespace anamorph
