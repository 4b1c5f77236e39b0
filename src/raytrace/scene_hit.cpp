#include "raytrace/scene_hit.h"

#include <algorithm>
#include <cmath>

#include "raytrace/look.h"

namespace anamorph {
namespace {

double smoothStep(double from, double to, double x) {
  const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

// Nothing where it has faded away.
std::optional<SceneHit> intersectGround(const RenderScene& scene, const Ray& ray, double tMax) {
  const auto t = intersect(floorOf(*scene.input.ground, scene), ray, tMax);
  if (!t) return std::nullopt;
  SceneHit hit{{ObjectKind::ground, 0}, *t, ray.at(*t), {0, 0, 1}, {0, 0, 1}, 0};
  hit.point.z = scene.input.ground->height;
  const double away = std::hypot(hit.point.x - scene.centre.x, hit.point.y - scene.centre.y) / scene.radius;
  hit.groundFade = smoothStep(look::fadeStart, look::fadeEnd, away);
  return hit;
}

Direction unitOr(const Vector& v, const Direction& otherwise) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

// The point is taken from the triangle and not from the ray: then it lies in the triangle's plane however far
// away the eye is.
SceneHit meshHit(const MeshSurface& surface, int index, const Ray& ray, const BvhHit& bvhHit) {
  const PointArray& points = surface.mesh->positions;
  const Triangle& triangle = surface.mesh->triangles[bvhHit.triangle];
  const double u = bvhHit.u, v = bvhHit.v, w = 1 - u - v;
  const Point point = w * points[triangle[0]] + u * points[triangle[1]] + v * points[triangle[2]];

  Direction face = unitOr(areaVector(points, triangle), -ray.direction);
  Direction normal = face;
  if (surface.normals) {
    const Triangle& corners = surface.normalGroups->corners[bvhHit.triangle];
    const auto& normals = *surface.normals;
    normal = unitOr(
        w * Vector(normals[corners[0]]) + u * Vector(normals[corners[1]]) + v * Vector(normals[corners[2]]),
        face);
  }
  if (glm::dot(face, ray.direction) > 0) face = -face;
  if (glm::dot(normal, face) < 0) normal = -normal;
  return {{ObjectKind::mesh, index}, bvhHit.t, point, face, normal, 0};
}

}  // namespace

std::optional<SceneHit> findHit(const RenderScene& scene, const Ray& ray, double tMax) {
  std::optional<SceneHit> hit;
  if (scene.input.ground) {
    hit = intersectGround(scene, ray, tMax);
    if (hit) tMax = hit->t;
  }
  if (scene.input.optic) {
    const auto opticHit = intersectVisible(scene.input.optic->optic, ray);
    if (opticHit && opticHit->t < tMax) {
      tMax = opticHit->t;
      const ObjectId part{ObjectKind::optic, static_cast<int>(opticHit->part)};
      hit = SceneHit{part, tMax, opticHit->point, opticHit->normal, opticHit->normal, 0};
    }
  }
  BvhHit nearest;
  int surface = -1;
  for (std::size_t i = 0; i < scene.input.surfaces.size(); ++i) {
    if (scene.input.surfaces[i].bvh->closestHit(ray, nearest, 0, tMax)) {
      tMax = nearest.t;
      surface = static_cast<int>(i);
    }
  }
  if (surface >= 0) hit = meshHit(scene.input.surfaces[surface], surface, ray, nearest);
  return hit;
}

bool isBlocked(const RenderScene& scene, const Ray& ray, double tMax) {
  for (const MeshSurface& surface : scene.input.surfaces) {
    if (surface.bvh->anyHit(ray, 0, tMax)) return true;
  }
  if (scene.input.optic) {
    const auto hit = intersectVisible(scene.input.optic->optic, ray);
    if (hit && hit->t < tMax) return true;
  }
  return scene.input.ground && intersectGround(scene, ray, tMax);
}

}  // namespace anamorph
