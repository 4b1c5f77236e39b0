#include "anamorphosis/vertex_ray.h"

#include <algorithm>

namespace anamorph {

MappedPoint mapPoint(const Optic& optic, const Point& eye, const Point& original, double depthScale) {
  const Vector towards = original - eye;
  if (!(lengthSquared(towards) > 0)) return {original, PathStatus::inFrontOfMirror};
  const OpticPath path = followRay(optic, {eye, towards});
  const double exitLength = depthScale * (1 - path.travelled);
  const PathStatus status = statusOf(optic, path, exitLength);
  if (status != PathStatus::mapped) return {original, status};
  return {path.exit.at(exitLength), status};
}

VertexRay makeVertexRay(const Optic& optic, const Point& eye, const Point& original, double depthScale) {
  VertexRay ray;
  ray.eye = eye;
  ray.original = original;
  const MappedPoint mapped = mapPoint(optic, eye, original, depthScale);
  ray.sculpture = mapped.point;
  ray.status = mapped.status;
  const Vector towards = original - eye;
  if (!(lengthSquared(towards) > 0)) return ray;
  const OpticPath path = followRay(optic, {eye, towards});
  if (path.pointCount == 0) return ray;
  const int last = path.pointCount - 1;
  ray.mirror = path.points[last];
  ray.normal = path.normals[last];
  ray.reflected = glm::normalize(path.exit.direction);
  ray.distance = std::abs(1 - path.travelled) * glm::length(towards);
  ray.angleDegrees = degrees(std::acos(std::clamp(path.sine, 0.0, 1.0)));
  return ray;
}

}  // namespace anamorph
