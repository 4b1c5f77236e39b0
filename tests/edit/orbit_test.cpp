#include "edit/orbit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

ViewPose randomPose(Random& random, bool level) {
  ViewPose pose;
  pose.eye = random.point(20);
  pose.target = random.point(5);
  pose.up = level ? Direction(0, 0, 1) : random.direction();
  pose.fovDegrees = random.uniform(15, 100);
  pose.orthographic = random.integer(0, 1) == 1;
  return pose;
}

ViewProjection projectionOf(const ViewPose& pose) {
  return {pose, 800, 600};
}

double distanceOf(const ViewPose& pose) {
  return glm::length(pose.eye - pose.target);
}

void expectSound(const ViewPose& pose) {
  EXPECT_TRUE(isFinite(pose.eye) && isFinite(pose.target) && isFinite(pose.up));
  EXPECT_GT(distanceOf(pose), 0);
  EXPECT_GT(glm::length(pose.up), 0);
  EXPECT_TRUE(isFinite(frameOf(pose).right));
}

// How far the picture has turned, for small turns about in radians.
double frameChange(const ViewPose& a, const ViewPose& b) {
  const Frame f = frameOf(a), g = frameOf(b);
  return glm::length(f.right - g.right) + glm::length(f.up - g.up) + glm::length(f.forward - g.forward);
}

TEST(Orbit, HoldsTheSceneAtTheMouse) {
  const ViewPose front{{0, -10, 0}, {0, 0, 0}};
  const ViewPose right = orbit(front, 50, 0);
  const ViewPose down = orbit(front, 0, 50);
  const Point nearSide(0, -1, 0);
  EXPECT_GT(projectionOf(right).pixelOf(nearSide)->x, 400 + 1);
  EXPECT_GT(projectionOf(down).pixelOf(nearSide)->y, 300 + 1);
  EXPECT_NEAR(degrees(std::atan2(right.eye.x, -right.eye.y)), -20, 1e-9) << "0.4 degrees a pixel";
}

TEST(KeptAbove, AMotionEndsAtTheFloorUnlessItBeginsBelow) {
  int stopped = 0, free = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ViewPose pose = randomPose(random, true);
    const double floor = random.uniform(-5, 5), x = random.uniform(-300, 300), y = random.uniform(-300, 300);
    const auto moved = [&](double part) { return orbit(pose, x, part * y); };
    const ViewPose kept = keptAbove(floor, pose, moved), whole = moved(1);
    if (!(pose.eye.z > floor) || whole.eye.z > floor) {
      EXPECT_EQ(kept, whole);
      ++free;
    } else {
      EXPECT_GT(kept.eye.z, floor);
      EXPECT_LT(kept.eye.z, floor + 1e-3 * distanceOf(pose));
      ++stopped;
    }
  }
  EXPECT_GT(stopped, 100);
  EXPECT_GT(free, 100);
}

TEST(Orbit, KeepsTargetDistanceAndHorizon) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ViewPose pose = randomPose(random, true);
    const double dx = random.uniform(-2000, 2000), dy = random.uniform(-400, 400);
    const ViewPose turned = orbit(pose, dx, dy);
    EXPECT_EQ(turned.target, pose.target);
    EXPECT_NEAR(distanceOf(turned), distanceOf(pose), 1e-12 * distanceOf(pose));
    EXPECT_TRUE(isLevel(turned));
    EXPECT_EQ(turned.up, Direction(0, 0, 1));
    const double pitch = degrees(std::asin(-frameOf(turned).forward.z));
    EXPECT_LE(std::abs(pitch), orbitMaxPitchDegrees + 1e-6);
    if (std::abs(pitch) < 89) {  // not stopped at a pole: the way back leads back
      EXPECT_LT(glm::length(orbit(turned, -dx, -dy).eye - pose.eye), 1e-9 * distanceOf(pose));
    }
  }
}

TEST(Orbit, StartsWithoutAJumpFromAnyPose) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    ViewPose pose = randomPose(random, false);
    if (seed % 5 == 0) pose.up = frameOf(pose).forward;  // along the line of sight
    if (seed % 7 == 0) pose = viewFrom(pose, seed % 2 ? ViewSide::top : ViewSide::bottom);
    EXPECT_EQ(orbit(pose, 0, 0), pose);
    const ViewPose turned = orbit(pose, random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01));
    // Straight up and down are beyond where the pitch ends, by a tenth of a degree.
    EXPECT_LT(frameChange(pose, turned), seed % 7 == 0 ? 0.01 : 1e-3);
  }
}

TEST(Orbit, StopsJustBeforeThePole) {
  const ViewPose over = orbit({{0, -10, 0}, {0, 0, 0}}, 0, 10000);
  EXPECT_NEAR(degrees(std::asin(over.eye.z / 10)), orbitMaxPitchDegrees, 1e-6);
  EXPECT_LT(over.eye.y, 0) << "still from the front";
}

TEST(Upright, BringsZUpAndKeepsTheLineOfSight) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ViewPose pose = randomPose(random, false), level = upright(pose);
    EXPECT_TRUE(isLevel(level));
    EXPECT_EQ(level.eye, pose.eye);
    EXPECT_EQ(level.target, pose.target);
  }
}

TEST(Pan, FollowsTheMouse) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ViewPose pose = randomPose(random, random.integer(0, 1) == 1);
    const ViewProjection before = projectionOf(pose);
    const double dx = random.uniform(-300, 300), dy = random.uniform(-300, 300);
    const ViewPose moved = pan(pose, before, dx, dy);
    const Frame& frame = before.frame();
    const Point held = pose.target + random.uniform(-3, 3) * frame.right + random.uniform(-3, 3) * frame.up;
    EXPECT_LT(glm::length(*projectionOf(moved).pixelOf(held) - *before.pixelOf(held) - Pixel(dx, dy)), 1e-6);
    EXPECT_LT(frameChange(pose, moved), 1e-9);
  }
}

TEST(Zoom, KeepsThePointUnderTheCursor) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ViewPose pose = randomPose(random, random.integer(0, 1) == 1);
    const ViewProjection before = projectionOf(pose);
    const Frame& frame = before.frame();
    const Point point = pose.target + random.uniform(-3, 3) * frame.right + random.uniform(-3, 3) * frame.up;
    const Pixel pixel = *before.pixelOf(point);
    const double steps = random.uniform(-8, 8);
    const ViewPose zoomed = zoomTo(pose, before, pixel, steps);
    EXPECT_LT(glm::length(*projectionOf(zoomed).pixelOf(point) - pixel), 1e-5);
    EXPECT_NEAR(distanceOf(zoomed) * std::pow(zoomPerStep, steps), distanceOf(pose), 1e-9 * distanceOf(pose));
    EXPECT_LT(frameChange(pose, zoomed), 1e-6);
    const Point any = pose.target + random.point(1);
    const auto seen = before.pixelOf(any);
    if (!seen) continue;
    const ViewPose towards = zoomTowards(pose, any, steps);
    EXPECT_LT(glm::length(*projectionOf(towards).pixelOf(any) - *seen), 1e-4);
  }
}

TEST(Zoom, EndsAtTheDistances) {
  for (const bool parallel : {false, true}) {
    ViewPose pose;
    pose.orthographic = parallel;
    EXPECT_NEAR(distanceOf(zoomTo(pose, projectionOf(pose), {400, 300}, 1e4)), minViewDistance, 1e-9);
    EXPECT_NEAR(distanceOf(zoomTo(pose, projectionOf(pose), {10, 300}, -1e4)), maxViewDistance, 1e-3);
  }
}

TEST(SetCentre, BringsThePointToTheMiddle) {
  const ViewPose pose, centred = setCentre(pose, {3, 4, 5});
  EXPECT_LT(glm::length(*projectionOf(centred).pixelOf({3, 4, 5}) - Pixel(400, 300)), 1e-9);
  EXPECT_NEAR(distanceOf(centred), distanceOf(pose), 1e-12);
}

TEST(FrameBox, TheBoxJustFits) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const ViewPose pose = randomPose(random, random.integer(0, 1) == 1);
    Box box;
    box.extend(random.point(10));
    box.extend(random.point(10));
    const int width = random.integer(200, 1600), height = random.integer(200, 1600);
    const ViewPose framed = frameBox(pose, box, double(width) / height);
    EXPECT_LT(frameChange(pose, framed), 1e-9);
    const ViewProjection projection(framed, width, height);
    double closest = 1e9;
    for (int i = 0; i < 8; ++i) {
      const Point corner(i & 1 ? box.max.x : box.min.x, i & 2 ? box.max.y : box.min.y,
                         i & 4 ? box.max.z : box.min.z);
      const auto pixel = projection.pixelOf(corner);
      ASSERT_TRUE(pixel);
      closest = std::min(
          {closest, pixel->x / width, 1 - pixel->x / width, pixel->y / height, 1 - pixel->y / height});
    }
    EXPECT_GE(closest, 0);
    if (!framed.orthographic) {
      EXPECT_NEAR(closest, 0.5 - 0.5 / 1.08, 1e-6) << "with a little air, and no more";
    }
  }
  const ViewPose pose;
  EXPECT_EQ(frameBox(pose, {}, 1), pose);
  EXPECT_EQ(frameBox(pose, {{1, 1, 1}, {1, 1, 1}}, 1), setCentre(pose, {1, 1, 1}));
}

TEST(ViewFrom, ShowsTheSidesAsDrawingsDo) {
  const ViewPose pose;
  const auto frame = [&](ViewSide side) { return frameOf(viewFrom(pose, side)); };
  EXPECT_LT(glm::length(frame(ViewSide::front).right - Vector(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(frame(ViewSide::back).right - Vector(-1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(frame(ViewSide::right).right - Vector(0, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(frame(ViewSide::left).right - Vector(0, -1, 0)), 1e-12);
  EXPECT_LT(glm::length(frame(ViewSide::top).right - Vector(1, 0, 0)), 1e-12);
  EXPECT_LT(glm::length(frame(ViewSide::top).up - Vector(0, 1, 0)), 1e-12);
  EXPECT_LT(glm::length(frame(ViewSide::bottom).right - Vector(1, 0, 0)), 1e-12);
  for (const ViewSide side :
       {ViewSide::front, ViewSide::back, ViewSide::left, ViewSide::right, ViewSide::top, ViewSide::bottom}) {
    EXPECT_TRUE(isLevel(viewFrom(pose, side)));
    EXPECT_EQ(viewFrom(pose, side).target, pose.target);
    EXPECT_NEAR(distanceOf(viewFrom(pose, side)), distanceOf(pose), 1e-12);
  }
}

TEST(TogglePerspective, KeepsTheSizeAtTheTarget) {
  const ViewPose pose, parallel = togglePerspective(pose);
  EXPECT_NE(parallel.orthographic, pose.orthographic);
  EXPECT_NEAR(projectionOf(parallel).unitsPerPixel(pose.target),
              projectionOf(pose).unitsPerPixel(pose.target), 1e-12);
  EXPECT_EQ(togglePerspective(parallel), pose);
}

TEST(Navigation, AbsurdPosesAndMotionsGiveSoundPoses) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  ViewPose atTarget, noUp, upAlongSight, broken;
  atTarget.eye = atTarget.target;
  noUp.up = Vector(0);
  upAlongSight.up = glm::normalize(upAlongSight.target - upAlongSight.eye);
  broken.eye = Point(nan);
  broken.fovDegrees = infinite;
  const ViewProjection projection = projectionOf({});
  for (const ViewPose& pose : {atTarget, noUp, upAlongSight, broken}) {
    for (const double amount : {0.0, 1e-300, 3.0, -1e300, nan, infinite}) {
      expectSound(orbit(pose, amount, -amount));
      expectSound(pan(pose, projection, amount, 1));
      expectSound(zoomTo(pose, projection, {amount, 2}, 1));
      expectSound(zoomTo(pose, projection, {4, 2}, amount));
      expectSound(setCentre(pose, {amount, 0, 0}));
      expectSound(frameBox(pose, {{0, 0, 0}, {1, 1, std::abs(amount)}}, 1));
    }
    expectSound(viewFrom(pose, ViewSide::top));
    expectSound(upright(pose));
  }
}

}  // namespace
}  // namespace anamorph
