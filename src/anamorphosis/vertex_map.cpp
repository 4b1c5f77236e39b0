#include "anamorphosis/vertex_map.h"

#include "optics/reflect.h"

namespace anamorph {
namespace {

std::size_t lastOf(const OpticPath& path) {
  return static_cast<std::size_t>(path.pointCount - 1);
}

// The normal as it would be if the mirror were a sphere about its middle; only for those that the published
// program took for one.
Direction publishedNormal(const Optic& optic, const OpticPath& path) {
  const Point& point = path.points[lastOf(path)];
  const Direction& exact = path.normals[lastOf(path)];
  const auto normal = optic.parts.back().shape->publishedNormal(point);
  if (!normal) return exact;
  return glm::dot(*normal, exact) < 0 ? -*normal : *normal;
}

// Whether the formulas can be used at all. That the ray then goes through the mirror is one of their faults.
PathStatus publishedStatus(const OpticPath& path) {
  if (path.travelled > 1) return PathStatus::inFrontOfMirror;
  return path.sine < grazingSine ? PathStatus::grazing : PathStatus::mapped;
}

MappedPoint mapPublished(const VertexMap& map, const OpticPath& path, const Point& original) {
  const PathStatus status = publishedStatus(path);
  if (status != PathStatus::mapped) return {original, status};
  const PublishedRay ray = followPublished(map, path, original);
  if (!isFinite(ray.sculpture)) return {original, PathStatus::grazing};
  return {ray.sculpture, status};
}

}  // namespace

PublishedRay followPublished(const VertexMap& map, const OpticPath& path, const Point& original) {
  const std::size_t last = lastOf(path);
  const Vector towards = original - map.eye, incoming = last > 0 ? path.onward[last - 1] : towards;
  const Point mirror = path.points[last];
  PublishedRay ray;
  ray.normal = map.mistakes.normal ? publishedNormal(map.optic, path) : path.normals[last];
  ray.reflected = glm::normalize(reflect(map.mistakes.direction ? -incoming : incoming, ray.normal));
  ray.distance = glm::length(map.mistakes.distance ? towards - mirror : original - mirror);
  ray.sculpture = mirror + (map.depthScale * ray.distance + map.depthOffset) * ray.reflected;
  return ray;
}

bool makesMistakes(const VertexMap& map, const OpticPath& path) {
  return map.mistakes.any() && path.pointCount > 0 && path.bends;
}

double exitLength(const VertexMap& map, const OpticPath& path, const Vector& towards) {
  const double rest = map.depthScale * (1 - path.travelled);
  return map.depthOffset == 0 ? rest : rest + map.depthOffset / glm::length(towards);
}

MappedPoint mapPoint(const VertexMap& map, const Point& original) {
  const Vector towards = original - map.eye;
  if (!(lengthSquared(towards) > 0)) return {original, PathStatus::inFrontOfMirror};
  return mapAlong(map, followRay(map.optic, {map.eye, towards}), original);
}

MappedPoint mapAlong(const VertexMap& map, const OpticPath& path, const Point& original) {
  if (makesMistakes(map, path)) return mapPublished(map, path, original);
  const double length = exitLength(map, path, original - map.eye);
  const PathStatus status = statusOf(map.optic, path, length);
  if (status != PathStatus::mapped) return {original, status};
  return {path.exit.at(length), status};
}

}  // namespace anamorph
