#include "anamorphosis/vertex_ray.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "optics/reflect.h"

namespace anamorph {
namespace {

// The normal as it would be if the cylinder were a sphere about its middle.
Direction publishedNormal(const Optic& optic, const OpticPath& path) {
  const auto* cylinder = std::get_if<CylinderMirror>(&optic.shape);
  if (!cylinder) return path.normals[0];
  const Direction normal = glm::normalize(path.points[0] - middleOf(*cylinder));
  return glm::dot(normal, path.normals[0]) < 0 ? -normal : normal;
}

// The construction with some of the published formulas in place of the right ones.
struct PublishedRay {
  Direction normal{0};
  Direction reflected{0};  // unit
  double distance = 0;     // without the depth scale
  Point sculpture{0};
};

PublishedRay followPublished(const Optic& optic, const OpticPath& path, const Point& eye,
                             const Point& original, double depthScale, const Mistakes& mistakes) {
  const Vector towards = original - eye;
  const Point mirror = path.points[0];
  PublishedRay ray;
  ray.normal = mistakes.normal ? publishedNormal(optic, path) : path.normals[0];
  ray.reflected = glm::normalize(reflect(mistakes.direction ? -towards : towards, ray.normal));
  ray.distance = glm::length(mistakes.distance ? towards - mirror : original - mirror);
  ray.sculpture = mirror + depthScale * ray.distance * ray.reflected;
  return ray;
}

// Whether the formulas can be used at all. That the ray then goes through the mirror is one of their faults.
PathStatus publishedStatus(const OpticPath& path) {
  if (path.pointCount == 0) return PathStatus::missesMirror;
  if (path.travelled > 1) return PathStatus::inFrontOfMirror;
  return path.sine < grazingSine ? PathStatus::grazing : PathStatus::mapped;
}

bool makesMistakes(const Optic& optic, const Mistakes& mistakes) {
  return mistakes.any() && optic.kind == OpticKind::mirror;
}

}  // namespace

MappedPoint mapPoint(const Optic& optic, const Point& eye, const Point& original, double depthScale,
                     const Mistakes& mistakes) {
  const Vector towards = original - eye;
  if (!(lengthSquared(towards) > 0)) return {original, PathStatus::inFrontOfMirror};
  const OpticPath path = followRay(optic, {eye, towards});
  if (makesMistakes(optic, mistakes)) {
    const PathStatus status = publishedStatus(path);
    if (status != PathStatus::mapped) return {original, status};
    const PublishedRay ray = followPublished(optic, path, eye, original, depthScale, mistakes);
    if (!isFinite(ray.sculpture)) return {original, PathStatus::grazing};
    return {ray.sculpture, status};
  }
  const double exitLength = depthScale * (1 - path.travelled);
  const PathStatus status = statusOf(optic, path, exitLength);
  if (status != PathStatus::mapped) return {original, status};
  return {path.exit.at(exitLength), status};
}

VertexRay makeVertexRay(const Optic& optic, const Point& eye, const Point& original, double depthScale,
                        const Mistakes& mistakes) {
  VertexRay ray;
  ray.eye = eye;
  ray.original = original;
  const MappedPoint mapped = mapPoint(optic, eye, original, depthScale, mistakes);
  ray.sculpture = mapped.point;
  ray.status = mapped.status;
  const Vector towards = original - eye;
  if (!(lengthSquared(towards) > 0)) return ray;
  const OpticPath path = followRay(optic, {eye, towards});
  if (path.pointCount == 0) return ray;
  const auto last = static_cast<std::size_t>(path.pointCount - 1);
  ray.mirror = path.points[last];
  ray.normal = path.normals[last];
  ray.reflected = glm::normalize(path.exit.direction);
  ray.distance = std::abs(1 - path.travelled) * glm::length(towards);
  if (makesMistakes(optic, mistakes)) {
    const PublishedRay published = followPublished(optic, path, eye, original, depthScale, mistakes);
    ray.normal = published.normal;
    ray.reflected = published.reflected;
    ray.distance = published.distance;
  }
  const double cosine = std::abs(glm::dot(ray.normal, towards)) / glm::length(towards);
  ray.angleDegrees = degrees(std::acos(std::clamp(cosine, 0.0, 1.0)));
  return ray;
}

}  // namespace anamorph
