#include "edit/level_repairs.h"

#include <gtest/gtest.h>

#include <string>

#include "edit/edit_levels.h"
#include "geometry/shapes.h"
#include "pipeline/original.h"
#include "pipeline/stages.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

Box boxOfOriginal(const Level& level) {
  return boundingBox(placeOriginal(makeBox({2, 1, 1}, 4), false, level.original.placement)->positions);
}

// The sum over both ends of how far a point is from the surface does not matter; only the nearest is asked
// for.
double distanceToSurface(const Shape& shape, const Point& p) {
  if (const auto* sphere = shape.as<SphereMirror>()) return glm::length(p - sphere->centre) - sphere->radius;
  const auto& tube = shapeAs<CylinderMirror>(shape);
  const Direction axis = glm::normalize(tube.top - tube.bottom);
  return glm::length(glm::cross(p - tube.bottom, axis)) - tube.radius;
}

TEST(EyeMovedOutside, PutsTheEyeARadiusBeforeTheMirror) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = makeRandomLevel(kind, random);
      const Box box = boxOfOriginal(level);
      EXPECT_EQ(eyeMovedOutside(level, box), level) << "nothing is wrong";
      if (const auto* plane = level.optic.shape().as<PlaneMirror>()) {
        level.camera.eye = glm::mix(plane->corners[0], plane->corners[1], 2.0);
      } else {  // it touches the surface
        level.camera.eye = pointAt(level.optic.shape(), random.uniform(0, 1), random.uniform(0, 1));
      }
      ASSERT_TRUE(findEyeProblem(level.optic.shape(), level.camera.eye));
      const Level repaired = eyeMovedOutside(level, box);
      EXPECT_FALSE(findEyeProblem(repaired.optic.shape(), repaired.camera.eye));
      if (kind != ShapeKind::cylinder && kind != ShapeKind::sphere) continue;
      const double radius = kind == ShapeKind::sphere ? shapeAs<SphereMirror>(level.optic.shape()).radius
                                                      : shapeAs<CylinderMirror>(level.optic.shape()).radius;
      EXPECT_NEAR(distanceToSurface(repaired.optic.shape(), repaired.camera.eye), radius, 1e-6 * radius);
    }
  }
}

TEST(EyeMovedOutside, ChoosesTheSideAwayFromTheOriginal) {
  Level level;
  level.optic.shape() = SphereMirror{{0, 0, 4}, 4};
  level.camera.eye = {0, 4, 4};
  const Level repaired = eyeMovedOutside(level, {{-1, 4, 3}, {1, 6, 5}});
  EXPECT_LT(glm::length(repaired.camera.eye - Point(0, -8, 4)), 1e-12);
}

TEST(OriginalMovedBehind, LeavesNoVertexInFrontOfTheMirror) {
  int changed = 0;
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 100; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = makeRandomLevel(kind, random);
      level.original.placement.position =
          glm::mix(level.camera.eye, level.camera.target, random.uniform(0.2, 1.2));
      const Level repaired = originalMovedBehind(level, boxOfOriginal(level));
      changed += repaired != level;
      const auto original = placeOriginal(makeBox({2, 1, 1}, 4), false, repaired.original.placement);
      MappedPoints mapped;
      mapPointsThrough({repaired.optic, repaired.camera.eye, 1, {}}, original->positions, mapped);
      EXPECT_EQ(countStatus(mapped.status)[std::size_t(PathStatus::inFrontOfMirror)], 0u);
    }
  }
  EXPECT_GT(changed, 150);
}

TEST(LevelRepairs, AbsurdLevelsStaySound) {
  for (const Level& level : makeAbsurdLevels()) {
    for (const Box& box : {Box{}, Box{level.camera.eye, level.camera.eye}, Box{{-1, -1, -1}, {1, 1, 1}}}) {
      EXPECT_TRUE(isSound(eyeMovedOutside(level, box)));
      EXPECT_TRUE(isSound(originalMovedBehind(level, box)));
    }
  }
}

}  // namespace
}  // namespace anamorph
