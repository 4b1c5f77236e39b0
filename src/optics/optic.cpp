#include "optics/optic.h"

#include <algorithm>
#include <limits>

#include "optics/reflect.h"

namespace anamorph {
namespace {

// As a share of the way travelled: far above rounding, far below what an image shows. A hit nearer than this
// is the point the ray starts from.
constexpr double sameSurfaceGap = 1e-9;

}  // namespace

const char* pathStatusName(PathStatus status) {
  constexpr const char* names[] = {"mapped", "missesMirror", "inFrontOfMirror", "grazing", "hitsMirrorAgain"};
  return names[static_cast<int>(status)];
}

const char* surfaceName(const Optic& optic) {
  return optic.kind == OpticKind::none ? "canvas" : "mirror";
}

OpticPath followRay(const Optic& optic, const Ray& ray) {
  OpticPath path;
  const auto hit = intersect(optic.shape, ray);
  if (!hit) return path;
  path.points[0] = hit->point;
  path.normals[0] = hit->normal;
  path.pointCount = 1;
  path.travelled = hit->t;
  path.sine = -glm::dot(hit->normal, ray.direction) / glm::length(ray.direction);
  path.exit = {hit->point,
               optic.kind == OpticKind::none ? ray.direction : reflect(ray.direction, hit->normal)};
  return path;
}

PathStatus statusOf(const Optic& optic, const OpticPath& path, double exitLength) {
  if (path.pointCount == 0) return PathStatus::missesMirror;
  if (optic.kind == OpticKind::none) {
    // Slid from before the canvas beyond the eye, where it is not seen.
    if (!(path.travelled + exitLength > 0)) return PathStatus::inFrontOfMirror;
    return path.sine < grazingSine ? PathStatus::grazing : PathStatus::mapped;
  }
  if (path.travelled > 1) return PathStatus::inFrontOfMirror;
  if (path.sine < grazingSine) return PathStatus::grazing;
  return freeLength(optic, path) < exitLength ? PathStatus::hitsMirrorAgain : PathStatus::mapped;
}

double freeLength(const Optic& optic, const OpticPath& path) {
  if (optic.kind == OpticKind::none) return std::numeric_limits<double>::infinity();
  const auto again = intersect(optic.shape, path.exit, sameSurfaceGap * std::max(1.0, path.travelled));
  return again ? again->t : std::numeric_limits<double>::infinity();
}

bool reversesHandedness(const Optic& optic) {
  switch (optic.kind) {
    case OpticKind::mirror:
      return true;
    case OpticKind::none:
      return false;
  }
  return false;
}

}  // namespace anamorph
