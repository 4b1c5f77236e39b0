#include "edit/gizmo_drag.h"

#include <gtest/gtest.h>

#include <string>

#include "edit/edit_levels.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr GizmoMode everyMode[] = {GizmoMode::move, GizmoMode::rotate, GizmoMode::scale};
constexpr GizmoHandle everyHandle[] = {GizmoHandle::x,  GizmoHandle::y,  GizmoHandle::z,  GizmoHandle::yz,
                                       GizmoHandle::zx, GizmoHandle::xy, GizmoHandle::all};

ViewPose lookAt(const Point& target, Random& random) {
  ViewPose pose{target + random.uniform(10, 30) * random.direction(), target + random.point(0.5)};
  pose.orthographic = random.integer(0, 1) == 1;
  return pose;
}

// A drag of the box with its gizmo at the box's position.
GizmoDragStart startOf(const Level& level, Part part, GizmoMode mode, GizmoHandle handle,
                       const ViewPose& pose) {
  const ViewProjection projection(pose, 800, 600);
  const Box sculptureBox{{-1, -4, 0}, {1, -2, 2}};
  const auto frame = frameOf(level, {part}, mode, false, {}, sculptureBox);
  return {level, {part}, frame.value_or(GizmoFrame{}), mode, handle, projection, {400, 300}};
}

// How well a pixel's ray fixes a place on an axis or in a plane.
bool isSteep(const GizmoDragStart& start, const Direction& axis, bool plane) {
  const double c = std::abs(glm::dot(viewDirection(start.projection, start.frame.origin), axis));
  return plane ? c > 0.2 : c < 0.95;
}

TEST(GizmoDrag, NoMotionLeavesTheLevelExactly) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 60; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const Level level = makeRandomLevel(kind, random);
      for (const Selection& selection : allSelections()) {
        for (const GizmoMode mode : everyMode) {
          for (const GizmoHandle handle : everyHandle) {
            GizmoDragStart start = startOf(level, selection.part, mode, handle, lookAt({0, 0, 0}, random));
            start.pixel = {random.uniform(0, 800), random.uniform(0, 600)};
            GizmoDrag drag(start);
            EXPECT_EQ(drag.levelAt(start.pixel), level);
            EXPECT_EQ(drag.levelAt(start.pixel, {.snap = true}), level);
            drag.levelAt({random.uniform(0, 800), random.uniform(0, 600)});
            if (mode != GizmoMode::rotate) {
              EXPECT_EQ(drag.levelAt(start.pixel), level) << "and back";
            }
          }
        }
      }
    }
  }
}

TEST(GizmoDrag, MovesToThePixelOfAKnownPoint) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Level level = makeRandomLevel(ShapeKind::sphere, random);
    const Point origin = level.original.placement.position;
    const ViewPose pose = lookAt(origin, random);
    for (const GizmoHandle handle : everyHandle) {
      GizmoDragStart start = startOf(level, Part::original, GizmoMode::move, handle, pose);
      Vector way = random.point(2);
      const int axis = axisOf(handle);
      if (axis == 3) {
        way -= glm::dot(way, start.projection.frame().forward) * start.projection.frame().forward;
      } else {
        const bool plane = handle >= GizmoHandle::yz;
        const Direction a = start.frame.axes[std::size_t(axis)];
        if (!isSteep(start, a, plane)) continue;
        way = plane ? way - glm::dot(way, a) * a : glm::dot(way, a) * a;
      }
      start.pixel = *start.projection.pixelOf(origin);
      const auto pixel = start.projection.pixelOf(origin + way);
      ASSERT_TRUE(pixel);
      GizmoDrag drag(start);
      const Point now = drag.levelAt(*pixel).original.placement.position;
      EXPECT_LT(glm::length(now - (origin + way)), 1e-7) << int(handle);
    }
  }
}

TEST(GizmoDrag, TurnsToThePixelOfAKnownPoint) {
  for (unsigned seed = 0; seed < 500; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Level level = makeRandomLevel(ShapeKind::plane, random);
    const Point origin = level.original.placement.position;
    GizmoDragStart start =
        startOf(level, Part::original, GizmoMode::rotate, everyHandle[seed % 3], lookAt(origin, random));
    const Direction axis = start.frame.axes[seed % 3];
    if (!isSteep(start, axis, true)) continue;
    const Direction a = perpendicular(axis), b = glm::cross(axis, a);
    const auto pixelAt = [&](double angle) {
      return *start.projection.pixelOf(origin + std::cos(angle) * a + std::sin(angle) * b);
    };
    start.pixel = pixelAt(0.3);
    GizmoDrag drag(start);
    const double angle = random.uniform(-20, 20);  // several turns
    Level turned = level;
    for (int i = 1; i <= 100; ++i) turned = drag.levelAt(pixelAt(0.3 + angle * i / 100));
    EXPECT_LT(differenceOf(turned, rotated(level, {Part::original}, origin, axis, angle)), 1e-6);
    EXPECT_EQ(drag.text().substr(drag.text().size() - 8), std::string(" about ") + "xyz"[seed % 3]);
  }
}

TEST(GizmoDrag, CountsWholeTurns) {
  Level level;
  level.original.placement.position = Point(0);
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::rotate, GizmoHandle::z, {{0, -1, 20}, {0, 0, 0}});
  const auto pixelAt = [&](double angle) {
    return *start.projection.pixelOf({std::cos(angle), std::sin(angle), 0});
  };
  start.pixel = pixelAt(0);
  GizmoDrag drag(start);
  Level turned;
  for (int i = 1; i <= 37; ++i) turned = drag.levelAt(pixelAt(radians(20.0 * i)));
  EXPECT_NEAR(turned.original.placement.rotationDegrees.z, 20, 1e-6) << "the same as without the turns";
  EXPECT_EQ(drag.text(), "740.0° about z");
  for (int i = 36; i >= 0; --i) turned = drag.levelAt(pixelAt(radians(20.0 * i)));
  EXPECT_NEAR(turned.original.placement.rotationDegrees.z, 0, 1e-6);
}

TEST(GizmoDrag, ARingSeenEdgeOnTurnsByMotionAlongIt) {
  Level level;
  level.original.placement.position = Point(0);
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::rotate, GizmoHandle::z, {{0, -10, 0}, {0, 0, 0}});
  start.pixel = {400, 300};
  GizmoDrag drag(start);
  // The front of the ring goes right for a counter-clockwise turn seen from above; up and down do nothing.
  EXPECT_NEAR(drag.levelAt({400 + gizmoPixels, 350}).original.placement.rotationDegrees.z, degrees(1), 1e-6);
}

TEST(GizmoDrag, ScalesByTheShareOfTheDistance) {
  Level level;
  level.original.placement.position = Point(0);
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::scale, GizmoHandle::x, {{0, -10, 3}, {0, 0, 0}});
  const auto pixelOf = [&](double x, double z) { return *start.projection.pixelOf({x, 0, z}); };
  start.pixel = pixelOf(1, 0);
  GizmoDrag drag(start);
  const auto scale = [&](const Level& edited) { return edited.original.placement.scale; };
  EXPECT_LT(glm::length(scale(drag.levelAt(pixelOf(2.5, 0))) - Vector(2.5, 1, 1)), 1e-9);
  EXPECT_EQ(drag.text(), "scale x 2.50");
  EXPECT_EQ(scale(drag.levelAt(pixelOf(-1, 0))), Vector(1e-6, 1, 1))
      << "beyond the origin it stays as small as a file can hold";
  EXPECT_LT(glm::length(scale(drag.levelAt(pixelOf(2.52, 0), {.snap = true})) - Vector(2.5, 1, 1)), 1e-9);
  start.handle = GizmoHandle::zx;
  start.pixel = pixelOf(1, 1);
  EXPECT_LT(glm::length(scale(GizmoDrag(start).levelAt(pixelOf(0.5, 0.5))) - Vector(0.5, 1, 0.5)), 1e-9);
  start.handle = GizmoHandle::all;
  EXPECT_EQ(scale(GizmoDrag(start).levelAt(start.pixel + Pixel(45, -45))), Vector(2));
  EXPECT_EQ(scale(GizmoDrag(start).levelAt(start.pixel + Pixel(-300, 0))), Vector(1e-6));
}

TEST(GizmoDrag, SnapsPositionsToTheGridAndWaysToSteps) {
  Level level;
  level.original.placement.position = {0.1, 0.2, 0.3};
  level.original.placement.rotationDegrees = {0, 0, 30};
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::move, GizmoHandle::x, {{0, -10, 3}, {0, 0, 0}});
  const Point origin = level.original.placement.position;
  const auto pixelOf = [&](const Vector& way) { return *start.projection.pixelOf(origin + way); };
  start.pixel = pixelOf({0, 0, 0});
  GizmoDrag global(start);
  const Point onGrid = global.levelAt(pixelOf({1.1, 0, 0}), {.snap = true}).original.placement.position;
  EXPECT_LT(glm::length(onGrid - Point(1.25, 0.2, 0.3)), 1e-12);
  EXPECT_EQ(global.text(), "x +1.15");
  start.frame = *frameOf(level, {Part::original}, GizmoMode::move, true, {}, {});
  const Direction axis = start.frame.axes[0];
  GizmoDrag local(start);
  const Point stepped = local.levelAt(pixelOf(1.1 * axis), {.snap = true}).original.placement.position;
  EXPECT_LT(glm::length(stepped - (origin + 1.0 * axis)), 1e-9);
  EXPECT_EQ(local.text(), "local x +1.00");
}

TEST(GizmoDrag, FineIsATenthFromThereOn) {
  Level level;
  level.original.placement.position = Point(0);
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::move, GizmoHandle::x, {{0, -10, 0}, {0, 0, 0}});
  const auto pixelOf = [&](double x) { return *start.projection.pixelOf({x, 0, 0}); };
  start.pixel = pixelOf(0);
  GizmoDrag drag(start);
  const auto x = [&](double at, bool fine) {
    return drag.levelAt(pixelOf(at), {.fine = fine}).original.placement.position.x;
  };
  EXPECT_NEAR(x(1, false), 1, 1e-9);
  EXPECT_NEAR(x(1, true), 1, 1e-9) << "no jump";
  EXPECT_NEAR(x(2, true), 1.1, 1e-9);
  EXPECT_NEAR(x(2, false), 1.1, 1e-9) << "no jump";
  EXPECT_NEAR(x(3, false), 2.1, 1e-9);
}

TEST(GizmoDrag, ALockedAxisReplacesTheHandle) {
  Level level;
  level.original.placement.position = Point(0);
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::move, GizmoHandle::all, {{3, -10, 4}, {0, 0, 0}});
  start.pixel = *start.projection.pixelOf(Point(0));
  GizmoDrag drag(start);
  const Pixel pixel = start.pixel + Pixel(70, -50);
  const Point free = drag.levelAt(pixel).original.placement.position;
  const Point locked = drag.levelAt(pixel, {.axisLock = 2}).original.placement.position;
  EXPECT_NE(free.x, 0);
  EXPECT_EQ(locked, Point(0, 0, locked.z));
  EXPECT_GT(locked.z, 0);
  EXPECT_EQ(drag.levelAt(pixel).original.placement.position, free);
}

TEST(GizmoDrag, KeepsTheLastGoodPlaceBeyondTheHorizon) {
  Level level;
  level.original.placement.position = Point(0);
  GizmoDragStart start =
      startOf(level, Part::original, GizmoMode::move, GizmoHandle::xy, {{0, -10, 2}, {0, 0, 2}});
  start.pixel = *start.projection.pixelOf(Point(0));
  GizmoDrag drag(start);
  const Level good = drag.levelAt({420, 310});
  EXPECT_EQ(drag.levelAt({420, 290}), good) << "above the horizon";
  EXPECT_EQ(drag.levelAt({420, 300}), good) << "at it";
}

TEST(GizmoDrag, AbsurdDragsGiveSoundLevels) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  Random random(1);
  std::vector<Level> levels = makeAbsurdLevels();
  levels.push_back({});
  for (const Level& level : levels) {
    for (const Selection& selection : allSelections()) {
      for (const GizmoMode mode : everyMode) {
        for (const GizmoHandle handle : everyHandle) {
          for (const ViewPose& pose :
               {lookAt({0, 0, 0}, random), ViewPose{{0, -10, 0}, {0, 0, 0}}, ViewPose{{0, 0, 0}, {0, 0, 0}},
                ViewPose{level.camera.eye, {0, 0, 1}}}) {
            GizmoDragStart start = startOf(level, selection.part, mode, handle, pose);
            start.selection = selection;
            GizmoDrag drag(start);
            for (int i = 0; i < 12; ++i) {
              const double far = i < 6 ? 500 : 1e7;
              Pixel pixel(random.uniform(-far, far), random.uniform(-far, far));
              if (i == 4) pixel.x = nan;
              if (i == 5) pixel.y = infinite;
              DragKeys keys{i % 2 == 1, i % 3 == 1, {}};
              if (i % 4 == 3) keys.axisLock = i;
              ASSERT_TRUE(isSound(drag.levelAt(pixel, keys)));
            }
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace anamorph
