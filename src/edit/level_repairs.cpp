#include "edit/level_repairs.h"

#include <algorithm>
#include <cmath>

#include "edit/level_edits.h"

namespace anamorph {
namespace {

// Of the ways away from the mirror's axis or centre: the eye's own `outwards` unless it leads to the
// original's side.
Direction wayOut(const Vector& outwards, const Vector& fromOriginal, const Direction& otherwise) {
  const auto usable = [](const Vector& v) { return isFinite(v) && glm::length(v) > 1e-9; };
  if (usable(outwards) && !(usable(fromOriginal) && glm::dot(outwards, fromOriginal) < 0)) {
    return glm::normalize(outwards);
  }
  return usable(fromOriginal) ? glm::normalize(fromOriginal) : otherwise;
}

// The three shapes; `original` is the middle of the original.
Point eyeOutside(const PlaneMirror& plane, const Point& eye, const Point& original) {
  const Direction normal = planeNormal(plane);
  const double size = glm::length(plane.corners[2] - plane.corners[0]);
  return eye + 0.5 * size * (glm::dot(normal, original - plane.corners[0]) > 0 ? -normal : normal);
}
Point eyeOutside(const CylinderMirror& cylinder, const Point& eye, const Point& original) {
  const Direction axis = glm::normalize(cylinder.top - cylinder.bottom);
  const auto across = [&](const Vector& v) { return v - glm::dot(v, axis) * axis; };
  const Vector w = eye - cylinder.bottom;
  const Direction out = wayOut(across(w), across(cylinder.bottom - original), perpendicular(axis));
  return cylinder.bottom + glm::dot(w, axis) * axis + 2 * cylinder.radius * out;
}
Point eyeOutside(const SphereMirror& sphere, const Point& eye, const Point& original) {
  const Direction out = wayOut(eye - sphere.centre, sphere.centre - original, Direction(0, -1, 0));
  return sphere.centre + 2 * sphere.radius * out;
}

// Points all over the box, its corners among them.
template <typename Test>
bool allOf(const Box& box, const Test& test) {
  constexpr int steps = 12;
  for (int i = 0; i <= steps; ++i) {
    for (int j = 0; j <= steps; ++j) {
      for (int k = 0; k <= steps; ++k) {
        if (!test(glm::mix(box.min, box.max, Vector(i, j, k) / double(steps)))) return false;
      }
    }
  }
  return true;
}

// Continued a little beyond its outline and far beyond its ends, where a box that is partly beside the mirror
// would be hard to judge by some of its points.
MirrorShape continued(MirrorShape mirror) {
  constexpr double far = 1e3, wider = 1.05;
  if (auto* plane = std::get_if<PlaneMirror>(&mirror)) {
    const Point middle = middleOf(*plane);
    for (Point& corner : plane->corners) corner = middle + far * (corner - middle);
  } else if (auto* cylinder = std::get_if<CylinderMirror>(&mirror)) {
    const Vector along = cylinder->top - cylinder->bottom;
    cylinder->bottom -= far * along;
    cylinder->top += far * along;
    cylinder->radius *= wider;
  } else if (auto* sphere = std::get_if<SphereMirror>(&mirror)) {
    sphere->radius *= wider;
  }
  return mirror;
}

// Behind the mirror and what continues it: through the open end of a cylinder its inner wall is seen, which
// is farther away. Rays that miss both do not count: there the box stands beside them.
bool isBehind(const MirrorShape& mirror, const Point& eye, const Direction& sight, const Box& box) {
  const MirrorShape whole = continued(mirror);
  return allOf(box, [&](const Point& p) {
    const Vector towards = p - eye;
    if (!(glm::dot(towards, sight) > 0)) return false;
    const auto hit = intersect(mirror, {eye, towards}), hitWhole = intersect(whole, {eye, towards});
    return !(hit && hit->t >= 1) && !(hitWhole && hitWhole->t >= 1);
  });
}

Box movedBox(const Box& box, const Vector& shift) {
  return {box.min + shift, box.max + shift};
}

// With a little air around it.
Box grown(const Box& box) {
  const Vector air(0.05 * box.diagonal());
  return {box.min - air, box.max + air};
}

// The shortest way along `sight` after which the box is behind; negative when there is none.
double wayBehind(const MirrorShape& mirror, const Point& eye, const Direction& sight, const Box& box,
                 double from) {
  const auto behind = [&](double way) { return isBehind(mirror, eye, sight, movedBox(box, way * sight)); };
  double far = std::max(from, box.diagonal());
  for (int i = 0; !behind(far); ++i) {
    if (i == 60) return -1;
    far *= 1.5;
  }
  double near = 0;
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (near + far);
    (behind(middle) ? far : near) = middle;
  }
  return far;
}

}  // namespace

Level eyeMovedOutside(const Level& level, const Box& originalBox) {
  const MirrorShape& mirror = level.optic.shape;
  if (findShapeProblem(mirror) || !findEyeProblem(mirror, level.camera.eye)) return level;
  const Point original = originalBox.empty() ? level.original.placement.position : originalBox.centre();
  const Point eye = clampedPoint(
      std::visit([&](const auto& shape) { return eyeOutside(shape, level.camera.eye, original); }, mirror));
  if (!isFinite(eye) || findEyeProblem(mirror, eye)) return level;
  Level result = level;
  result.camera.eye = eye;
  if (result.camera.target == eye) result.camera.target = original;
  return result;
}

Level originalMovedBehind(const Level& level, const Box& originalBox) {
  const MirrorShape& mirror = level.optic.shape;
  const Point eye = level.camera.eye;
  if (findShapeProblem(mirror) || findEyeProblem(mirror, eye) || originalBox.empty()) return level;
  const Point middle = originalBox.centre();
  const Point mirrorMiddle = middleOf(mirror);
  const double distance = glm::length(middle - eye), mirrorDistance = glm::length(mirrorMiddle - eye);
  if (!(mirrorDistance > 0) || !isFinite(middle)) return level;
  Direction sight = distance > 0 ? (middle - eye) / distance : (mirrorMiddle - eye) / mirrorDistance;
  const Box box = grown(originalBox);
  Vector shift(0);
  if (!intersect(mirror, {eye, sight})) {
    sight = (mirrorMiddle - eye) / mirrorDistance;
    shift = eye + distance * sight - middle;
  }
  if (shift == Vector(0) && isBehind(mirror, eye, sight, box)) return level;
  const double way = wayBehind(mirror, eye, sight, movedBox(box, shift), mirrorDistance);
  return way < 0 ? level : moved(level, {Part::original}, shift + way * sight);
}

}  // namespace anamorph
