#include "edit/level_edits.h"

#include <gtest/gtest.h>

#include <string>

#include "edit/edit_levels.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr GizmoMode everyMode[] = {GizmoMode::move, GizmoMode::rotate, GizmoMode::scale};

template <typename Body>
void forLevels(const Body& body) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 200; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const Level level = makeRandomLevel(kind, random);
      for (const Selection& selection : allSelections()) {
        SCOPED_TRACE("part " + std::to_string(int(selection.part)) + " " + std::to_string(selection.index));
        body(level, selection, random);
      }
    }
  }
}

TEST(FrameOf, StandsAtTheThing) {
  forLevels([](const Level& level, const Selection& selection, Random&) {
    Box sculptureBox;
    sculptureBox.extend(Point(1, 2, 3));
    for (const GizmoMode mode : everyMode) {
      for (const bool local : {false, true}) {
        const auto frame = frameOf(level, selection, mode, local, {}, sculptureBox);
        ASSERT_EQ(frame.has_value(), allows(level, selection, mode));
        if (!frame) continue;
        EXPECT_TRUE(isFinite(frame->origin));
        const auto& a = frame->axes;
        EXPECT_LT(glm::length(glm::cross(a[0], a[1]) - a[2]), 1e-9);
        EXPECT_NEAR(glm::length(a[0]), 1, 1e-9);
        EXPECT_NEAR(glm::length(a[1]), 1, 1e-9);
        if (!local && mode != GizmoMode::scale) {
          EXPECT_TRUE(frame->global());
        }
      }
    }
  });
}

TEST(FrameOf, UprightMirrorsHaveTheScenesAxes) {
  Level level;
  const auto axes = [&] { return frameOf(level, {Part::mirror}, GizmoMode::scale, true, {}, {})->axes; };
  const GizmoFrame global;
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(glm::length(axes()[std::size_t(i)] - global.axes[std::size_t(i)]), 1e-12);
  level.optic.shape() = CylinderMirror{{1, 2, 3}, {1, 2, 9}, 2};
  for (int i = 0; i < 3; ++i)
    EXPECT_LT(glm::length(axes()[std::size_t(i)] - global.axes[std::size_t(i)]), 1e-12);
  level.optic.shape() = CylinderMirror{{1, 2, 9}, {1, 2, 3}, 2};
  EXPECT_LT(glm::length(axes()[2] - Vector(0, 0, -1)), 1e-12);
}

TEST(FrameOf, AFarAwayPositionGivesWayToTheMiddle) {
  Level level;
  level.original.placement.position = {100, 0, 0};
  const Box box{{0, 0, 0}, {2, 2, 2}};
  EXPECT_EQ(frameOf(level, {Part::original}, GizmoMode::move, false, box, {})->origin, Point(1, 1, 1));
  level.original.placement.position = {0.5, 0.5, 0.5};
  EXPECT_EQ(frameOf(level, {Part::original}, GizmoMode::move, false, box, {})->origin, Point(0.5, 0.5, 0.5));
}

TEST(LevelEdits, NothingDoneLeavesTheLevelExactly) {
  forLevels([](const Level& level, const Selection& selection, Random& random) {
    EXPECT_EQ(moved(level, selection, Vector(0)), level);
    EXPECT_EQ(rotated(level, selection, random.point(3), random.direction(), 0), level);
    EXPECT_EQ(scaled(level, selection, random.point(3), Vector(1)), level);
  });
}

TEST(LevelEdits, WhatIsNotAllowedDoesNothing) {
  forLevels([](const Level& level, const Selection& selection, Random& random) {
    const auto same = [&](GizmoMode mode, const Level& edited) {
      EXPECT_EQ(edited != level, allows(level, selection, mode));
    };
    same(GizmoMode::move, moved(level, selection, {1, 2, 3}));
    same(GizmoMode::rotate, rotated(level, selection, random.point(3), random.direction(), 1));
    same(GizmoMode::scale, scaled(level, selection, random.point(3), Vector(1.5)));
  });
}

TEST(LevelEdits, EveryEditCanBeTakenBack) {
  forLevels([](const Level& level, const Selection& selection, Random& random) {
    const Vector way = random.point(5);
    EXPECT_LT(differenceOf(moved(moved(level, selection, way), selection, -way), level), 1e-12);
    const Point origin = random.point(3);
    const Direction axis = random.direction();
    const double angle = random.uniform(-7, 7);
    const Level turned = rotated(level, selection, origin, axis, angle);
    EXPECT_LT(differenceOf(rotated(turned, selection, origin, axis, -angle), level), 1e-9);
    Vector factors(random.uniform(0.2, 4), random.uniform(0.2, 4), random.uniform(0.2, 4));
    const Shape& mirror = level.optic.shape();
    const bool isTurned =
        mirror.as<CylinderMirror>() || mirror.as<ConeMirror>() || mirror.as<ParaboloidMirror>();
    if (isTurned) factors.y = factors.x;
    if (scalesUniformly(level, selection)) factors = Vector(factors.x);
    const Level larger = scaled(level, selection, origin, factors);
    EXPECT_LT(differenceOf(scaled(larger, selection, origin, 1.0 / factors), level), 1e-9);
  });
}

TEST(Moved, MovesEveryPointOfTheThingAlike) {
  Level level;
  const Vector way(1, -2, 3);
  const auto& corners = shapeAs<PlaneMirror>(level.optic.shape()).corners;
  const Level mirror = moved(level, {Part::mirror}, way);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(shapeAs<PlaneMirror>(mirror.optic.shape()).corners[i], corners[i] + way);
  }
  EXPECT_EQ(moved(level, {Part::eye}, way).camera.eye, level.camera.eye + way);
  EXPECT_EQ(moved(level, {Part::eye}, way).camera.target, level.camera.target)
      << "it goes on looking at its aim";
  EXPECT_EQ(moved(level, {Part::light, 1}, way).lights[1].position, level.lights[1].position + way);
}

TEST(Moved, EndsWhereCoordinatesEndWithoutBendingAnything) {
  const Level level, far = moved(level, {Part::mirror}, {1e9, 0, 0});
  const auto& corners = shapeAs<PlaneMirror>(far.optic.shape()).corners;
  EXPECT_EQ(corners[1].x, 1e6);
  EXPECT_EQ(corners[1].x - corners[0].x, 16);
}

TEST(Rotated, TurnsThePlacedMeshAboutThePoint) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Level level = makeRandomLevel(ShapeKind::sphere, random);
    const Point p = random.point(2), origin = random.point(4);
    const Direction axis = random.direction();
    const double angle = random.uniform(-3, 3);
    const Point before = PlacementMap(level.original.placement)(p) - origin;
    const Point after =
        PlacementMap(rotated(level, {Part::original}, origin, axis, angle).original.placement)(p) - origin;
    const Direction u = perpendicular(axis), v = glm::cross(axis, u);
    const double c = std::cos(angle), s = std::sin(angle), x = glm::dot(before, u), y = glm::dot(before, v);
    EXPECT_NEAR(glm::dot(after, axis), glm::dot(before, axis), 1e-9);
    EXPECT_NEAR(glm::dot(after, u), c * x - s * y, 1e-9);
    EXPECT_NEAR(glm::dot(after, v), s * x + c * y, 1e-9);
  }
}

TEST(Rotated, TurnsTheAimAroundTheEye) {
  Level level;
  level.camera.eye = {0, 0, 0};
  level.camera.target = {0, 5, 0};
  const Camera left = rotated(level, {Part::eye}, level.camera.eye, {0, 0, 1}, pi / 2).camera;
  EXPECT_LT(glm::length(left.target - Point(-5, 0, 0)), 1e-12);
  EXPECT_EQ(left.up, level.camera.up);
  const Camera rolled = rotated(level, {Part::eye}, level.camera.eye, {0, 1, 0}, pi / 2).camera;
  EXPECT_EQ(rolled.target, level.camera.target);
  EXPECT_LT(glm::length(rolled.up - Vector(1, 0, 0)), 1e-12);
}

TEST(Scaled, ChangesSizesAlongTheThingsOwnAxes) {
  Level level;
  level.optic.shape() = CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3};
  const auto cylinder = [&](const Vector& f) {
    return shapeAs<CylinderMirror>(scaled(level, {Part::mirror}, {0, 0, 5}, f).optic.shape());
  };
  EXPECT_EQ(cylinder({2, 1, 1}), (CylinderMirror{{0, 0, 0}, {0, 0, 10}, 6}));
  EXPECT_EQ(cylinder({1, 0.5, 1}), (CylinderMirror{{0, 0, 0}, {0, 0, 10}, 1.5}));
  EXPECT_EQ(cylinder({1, 1, 0.5}), (CylinderMirror{{0, 0, 2.5}, {0, 0, 7.5}, 3}));
  level.optic.shape() = SphereMirror{{0, 0, 4}, 4};
  const Level larger = scaled(level, {Part::mirror}, {0, 0, 4}, {1, 1.5, 1});
  EXPECT_EQ(shapeAs<SphereMirror>(larger.optic.shape()), (SphereMirror{{0, 0, 4}, 6}));
  EXPECT_EQ(scaled(level, {Part::sculpture}, {0, 0, 0}, Vector(0.5)).sculpture.depthScale, 0.5);
  EXPECT_EQ(scaled(level, {Part::sculpture}, {0, 0, 0}, Vector(0)).sculpture.depthScale, 0.01);
  EXPECT_EQ(scaled(level, {Part::sculpture}, {0, 0, 0}, Vector(1e9)).sculpture.depthScale, 100);
}

TEST(Scaled, ReachesTheSmallestThatAFileCanHaveAndNotBelow) {
  forLevels([](const Level& level, const Selection& selection, Random& random) {
    const Point origin = random.point(3);
    const Level flat = scaled(level, selection, origin, Vector(0));
    EXPECT_TRUE(isSound(flat));
    EXPECT_EQ(scaled(level, selection, origin, Vector(-2)), flat);
    if (selection.part == Part::original) {
      EXPECT_EQ(flat.original.placement.scale, Vector(1e-6));
    }
  });
}

TEST(LevelEdits, AbsurdLevelsAndNumbersStaySound) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  for (const Level& level : makeAbsurdLevels()) {
    for (const Selection& selection : allSelections()) {
      EXPECT_TRUE(isSound(level));
      boxOf(level, selection, {}, {});
      for (const GizmoMode mode : everyMode) frameOf(level, selection, mode, true, {}, {});
      for (const double amount : {0.0, 1e-300, -3.0, 1e300, nan, infinite}) {
        EXPECT_TRUE(isSound(moved(level, selection, {amount, -amount, 1})));
        EXPECT_TRUE(isSound(rotated(level, selection, {0, 0, 1}, {0, 0, 1}, amount)));
        EXPECT_TRUE(isSound(rotated(level, selection, {amount, 0, 1}, {0, 0, 1}, 1)));
        EXPECT_TRUE(isSound(rotated(level, selection, {0, 0, 1}, {0, 0, amount}, 1)));
        EXPECT_TRUE(isSound(scaled(level, selection, {0, 0, 1}, {amount, 1, 1})));
        EXPECT_TRUE(isSound(scaled(level, selection, {0, amount, 1}, Vector(2))));
      }
    }
  }
}

TEST(BoxOf, HoldsTheThing) {
  forLevels([](const Level& level, const Selection& selection, Random&) {
    if (selection.part != Part::mirror) return;
    const Box box = boxOf(level, selection, {}, {}),
              exact = boundingBox(tessellate(level.optic.shape(), 256).mesh.positions);
    EXPECT_LT(glm::length(box.min - exact.min) + glm::length(box.max - exact.max), 0.01);
  });
  EXPECT_TRUE(boxOf({}, {}, {}, {}).empty());
  EXPECT_EQ(boxOf({}, {Part::eye}, {}, {}).centre(), Level{}.camera.eye);
}

}  // namespace
}  // namespace anamorph
