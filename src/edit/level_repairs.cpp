#include "edit/level_repairs.h"

#include <algorithm>

#include "edit/level_edits.h"

namespace anamorph {
namespace {

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

// Behind the mirror and what continues it: through an open end the inner wall is seen, which
// is farther away. `whole`: the mirror continued. Rays that miss both do not count: there the box stands beside them.
bool isBehind(const Shape& mirror, const Shape& whole, const Point& eye, const Direction& sight,
              const Box& box) {
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
double wayBehind(const Shape& mirror, const Shape& whole, const Point& eye, const Direction& sight,
                 const Box& box, double from) {
  const auto behind = [&](double way) {
    return isBehind(mirror, whole, eye, sight, movedBox(box, way * sight));
  };
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
  const Shape& mirror = level.optic.shape();
  if (findShapeProblem(mirror) || !findEyeProblem(mirror, level.camera.eye)) return level;
  const Point original = originalBox.empty() ? level.original.placement.position : originalBox.centre();
  const Point eye = clampedPoint(eyeOutside(mirror, level.camera.eye, original));
  if (!isFinite(eye) || findEyeProblem(mirror, eye)) return level;
  Level result = level;
  result.camera.eye = eye;
  if (result.camera.target == eye) result.camera.target = original;
  return result;
}

Level originalMovedBehind(const Level& level, const Box& originalBox) {
  const Shape& mirror = level.optic.shape();
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
  const Shape whole = continued(mirror);
  if (shift == Vector(0) && isBehind(mirror, whole, eye, sight, box)) return level;
  const double way = wayBehind(mirror, whole, eye, sight, movedBox(box, shift), mirrorDistance);
  return way < 0 ? level : moved(level, {Part::original}, shift + way * sight);
}

const Repairs& RepairsStage::at(const Level& level, const Box& originalBox) {
  return memo_.get({level, originalBox}, [](const Input& input) {
    return Repairs{eyeMovedOutside(input.level, input.originalBox),
                   originalMovedBehind(input.level, input.originalBox) == input.level};
  });
}

}  // namespace anamorph
