#include "optics/optic.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/check.h"
#include "base/language.h"
#include "optics/reflect.h"

namespace anamorph {
namespace {

// As a fraction of the way travelled: far above rounding, far below what an image shows. A hit nearer than this
// is the point the ray starts from.
constexpr double sameSurfaceGap = 1e-9;

// What there is to know of each kind of part.
struct KindTraits {
  const char* surface;  // what messages call it
  bool visible;
};
constexpr KindTraits traits[] = {{"mirror", true}, {"canvas", false}};

const KindTraits& traitsOf(OpticKind kind) {
  return traits[static_cast<int>(kind)];
}

bool canBend(const Optic& optic) {
  return std::any_of(optic.parts.begin(), optic.parts.end(),
                     [](const OpticPart& part) { return part.kind != OpticKind::canvas; });
}

std::optional<OpticHit> nearestOf(const Optic& optic, const Ray& ray, double tMin, bool visibleOnly) {
  std::optional<OpticHit> nearest;
  for (std::size_t part = 0; part < optic.parts.size(); ++part) {
    if (visibleOnly && !traitsOf(optic.parts[part].kind).visible) continue;
    const auto hit = intersect(optic.parts[part].shape, ray, tMin);
    if (hit && !(nearest && nearest->t <= hit->t)) nearest = OpticHit{*hit, part};
  }
  return nearest;
}

// At which the ray that leaves a path is off the surface that it leaves.
double offItsSurface(const OpticPath& path) {
  return sameSurfaceGap * std::max(1.0, path.travelled);
}

bool meetsAgain(const Optic& optic, const OpticPath& path, double exitLength) {
  const double from = offItsSurface(path);
  return exitLength > from && std::any_of(optic.parts.begin(), optic.parts.end(), [&](const OpticPart& part) {
           return traitsOf(part.kind).visible && meetsBetween(part.shape, path.exit, from, exitLength);
         });
}

// Where a normal is a mean of its neighbours', it may send a ray to the other side of its own flat piece.
bool leavesIntoItsFacet(const SurfaceHit& hit, const Vector& before, const Vector& after) {
  return hit.facet != Vector(0) && glm::dot(before, hit.facet) * glm::dot(after, hit.facet) >= 0;
}

}  // namespace

bool isVisible(const Optic& optic) {
  return std::any_of(optic.parts.begin(), optic.parts.end(),
                     [](const OpticPart& part) { return traitsOf(part.kind).visible; });
}

bool isShown(const Optic& optic) {
  return isVisible(optic) && !findProblem(optic);
}

const char* surfaceName(const Optic& optic) {
  return traitsOf(optic.parts.front().kind).surface;
}

std::optional<std::string> findProblem(const Optic& optic) {
  for (const OpticPart& part : optic.parts) {
    const auto problem = findShapeProblem(part.shape);
    if (!problem) continue;
    return trFormat("the {} {} cannot be used: {}.", tr(shapeName(part.shape)),
                    tr(traitsOf(part.kind).surface), *problem);
  }
  return std::nullopt;
}

std::optional<std::string> findEyeProblem(const Optic& optic, const Point& eye) {
  for (const OpticPart& part : optic.parts) {
    if (auto problem = findEyeProblem(part.shape, eye)) return problem;
  }
  return std::nullopt;
}

Box boxOf(const Optic& optic) {
  Box box;
  for (const OpticPart& part : optic.parts) {
    if (!findShapeProblem(part.shape)) box.extend(boxOf(part.shape));
  }
  return box;
}

std::optional<OpticHit> intersect(const Optic& optic, const Ray& ray, double tMin) {
  return nearestOf(optic, ray, tMin, false);
}

std::optional<OpticHit> intersectVisible(const Optic& optic, const Ray& ray, double tMin) {
  return nearestOf(optic, ray, tMin, true);
}

Interaction interact(const Optic& optic, const Ray& ray, const OpticHit& hit) {
  switch (optic.parts[hit.part].kind) {
    case OpticKind::mirror:
      return {reflect(ray.direction, hit.normal), true};
    case OpticKind::canvas:
      break;
  }
  return {ray.direction, false};
}

const char* pathStatusName(PathStatus status) {
  constexpr const char* names[] = {"mapped", "missesMirror", "inFrontOfMirror", "grazing", "hitsMirrorAgain"};
  return names[static_cast<int>(status)];
}

const char* pathStatusWords(PathStatus status) {
  constexpr const char* words[] = {"are mapped", "miss the mirror", "are in front of the mirror",
                                   "graze the mirror", "meet the mirror twice"};
  return words[static_cast<int>(status)];
}

OpticPath followRay(const Optic& optic, const Ray& sent) {
  OpticPath path;
  CHECK(optic.parts.size() <= OpticPath::maxPoints);
  Ray ray = sent;
  const double length = glm::length(sent.direction);
  for (std::size_t part = 0; part < optic.parts.size(); ++part) {
    const double tMin = part == 0 ? 0 : offItsSurface(path);
    const auto hit = intersect(optic, ray, tMin);
    if (!hit || hit->part != part) {  // another part, or nothing, comes next: this is no way through
      path.pointCount = 0;
      return path;
    }
    const auto i = static_cast<std::size_t>(path.pointCount++);
    const auto [direction, bends] = interact(optic, ray, *hit);
    path.points[i] = hit->point;
    path.normals[i] = hit->normal;
    path.onward[i] = direction;
    path.bends |= bends;
    path.travelled += hit->t;
    const double before = std::abs(glm::dot(hit->normal, ray.direction)),
                 after = std::abs(glm::dot(hit->normal, direction));
    path.sine = leavesIntoItsFacet(*hit, ray.direction, direction)
                    ? 0
                    : std::min({path.sine, before / length, after / length});
    ray = path.exit = {hit->point, direction};
  }
  return path;
}

PathStatus statusOf(const Optic& optic, const OpticPath& path, double exitLength) {
  if (path.pointCount == 0) return PathStatus::missesMirror;
  if (!path.bends) {
    // Slid from before the canvas beyond the eye, where it is not seen.
    if (!(path.travelled + exitLength > 0)) return PathStatus::inFrontOfMirror;
    return path.sine < grazingSine ? PathStatus::grazing : PathStatus::mapped;
  }
  if (path.travelled > 1) return PathStatus::inFrontOfMirror;
  if (path.sine < grazingSine) return PathStatus::grazing;
  return meetsAgain(optic, path, exitLength) ? PathStatus::hitsMirrorAgain : PathStatus::mapped;
}

double freeLength(const Optic& optic, const OpticPath& path) {
  if (!path.bends) return std::numeric_limits<double>::infinity();
  const auto again = intersectVisible(optic, path.exit, offItsSurface(path));
  return again ? again->t : std::numeric_limits<double>::infinity();
}

bool hasBatch(const Optic& optic) {
  const OpticPart& first = optic.parts.front();
  return optic.parts.size() == 1 && first.kind == OpticKind::mirror && first.shape.clip().empty() &&
         first.shape->hasBatch();
}

std::size_t exitPoints(const Optic& optic, const ExitBlock& block) {
  CHECK(block.count <= exitBlockSize);
  return hasBatch(optic) ? optic.shape()->exitPoints(block) : followNone(block);
}

LineOfSight lineOfSight(const Optic& optic, const Ray& ray) {
  LineOfSight sight;
  const OpticPath path = followRay(optic, ray);
  sight.meets = path.pointCount > 0;
  sight.last = ray;
  if (!canBend(optic)) return sight;
  sight.ends = !sight.meets;
  if (sight.ends) return sight;
  sight.bends = path.points;
  sight.bendCount = path.pointCount;
  sight.last = path.exit;
  sight.length = freeLength(optic, path);
  return sight;
}

}  // namespace anamorph
