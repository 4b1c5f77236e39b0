#include "anamorphosis/vertex_ray.h"

#include <algorithm>
#include <cmath>

namespace anamorph {
namespace {

double angleDegrees(const Direction& a, const Direction& b) {
  return degrees(std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)));
}

// Between the normal and both rays, however the published formulas have turned them.
void measureAngles(VertexLeg& leg, const Direction& incoming) {
  leg.angleInDegrees = degrees(std::acos(std::clamp(std::abs(glm::dot(leg.normal, incoming)), 0.0, 1.0)));
  leg.angleOutDegrees = angleDegrees(leg.normal, leg.direction);
}

}  // namespace

VertexRay makeVertexRay(const VertexMap& map, const Point& original) {
  VertexRay ray;
  ray.eye = map.eye;
  ray.original = original;
  ray.sculpture = original;
  ray.status = PathStatus::inFrontOfMirror;  // the eye itself
  const Vector towards = original - map.eye;
  if (!(lengthSquared(towards) > 0)) return ray;
  const double length = glm::length(towards);
  const OpticPath path = followRay(map.optic, {map.eye, towards});
  const MappedPoint mapped = mapAlong(map, path, original);
  ray.sculpture = mapped.point;
  ray.status = mapped.status;
  ray.bends = path.bends;
  const double rest = (1 - path.travelled) * length;  // before a canvas it is negative
  ray.distance = std::abs(rest);
  ray.reach = std::abs(map.depthOffset + map.depthScale * rest);
  for (std::size_t i = 0; i < static_cast<std::size_t>(path.pointCount); ++i) {
    ray.legs.push_back({path.points[i], path.normals[i], glm::normalize(path.onward[i])});
  }
  if (makesMistakes(map, path)) {
    const PublishedRay published = followPublished(map, path, original);
    ray.legs.back().normal = published.normal;
    ray.legs.back().direction = published.reflected;
    ray.distance = published.distance;
    ray.reach = map.depthOffset + map.depthScale * ray.distance;
  }
  Direction incoming = towards / length;
  for (VertexLeg& leg : ray.legs) {
    measureAngles(leg, incoming);
    incoming = leg.direction;
  }
  return ray;
}

}  // namespace anamorph
