#include "edit/pose_flight.h"

#include <gtest/gtest.h>

#include "edit/orbit.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

ViewPose randomPose(Random& random, bool level) {
  ViewPose pose{random.point(20), random.point(5), level ? Direction(0, 0, 1) : random.direction()};
  pose.fovDegrees = random.uniform(15, 100);
  return pose;
}

double frameChange(const ViewPose& a, const ViewPose& b) {
  const Frame f = frameOf(a), g = frameOf(b);
  return glm::length(f.right - g.right) + glm::length(f.up - g.up) + glm::length(f.forward - g.forward);
}

TEST(PoseFlight, BeginsAndEndsExactly) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PoseFlight flight{randomPose(random, false), randomPose(random, false)};
    EXPECT_EQ(flight.poseAt(-1), flight.from);
    EXPECT_EQ(flight.poseAt(0), flight.from);
    EXPECT_EQ(flight.poseAt(flight.duration), flight.goal);
    EXPECT_EQ(flight.poseAt(1e9), flight.goal);
    EXPECT_FALSE(flight.endedAt(0.1));
    EXPECT_TRUE(flight.endedAt(0.2));
  }
}

TEST(PoseFlight, GoesInSmallSteps) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    PoseFlight flight{randomPose(random, seed % 2), randomPose(random, seed % 2)};
    if (seed % 3 == 0) flight.goal = viewFrom(flight.goal, ViewSide(random.integer(0, 5)));
    ViewPose before = flight.from;
    for (int i = 1; i <= 1000; ++i) {
      const ViewPose now = flight.poseAt(flight.duration * i / 1000);
      ASSERT_TRUE(isFinite(now.eye) && isFinite(now.up));
      ASSERT_LT(frameChange(before, now), 0.03) << i;
      ASSERT_LT(glm::length(now.target - before.target), 0.1) << i;
      if (seed % 2) {
        ASSERT_TRUE(isLevel(now)) << i;
      }
      before = now;
    }
  }
}

TEST(PoseFlight, DistanceChangesByEqualFactors) {
  const ViewPose far{{0, -100, 0}, {0, 0, 0}}, near{{0, -1, 0}, {0, 0, 0}};
  const ViewPose middle = PoseFlight{far, near}.poseAt(0.1);
  EXPECT_NEAR(glm::length(middle.eye - middle.target), 10, 1e-9);
}

TEST(PoseFlight, ASecondGoalIsReachedFromWhereItIs) {
  Random random(1);
  const PoseFlight first{randomPose(random, true), randomPose(random, true)};
  const ViewPose goal = randomPose(random, true);
  const PoseFlight second = retargeted(first, 0.07, goal);
  EXPECT_EQ(second.poseAt(0), first.poseAt(0.07));
  EXPECT_EQ(second.poseAt(0.2), goal);
}

TEST(PoseFlight, AbsurdPosesDoNoHarm) {
  ViewPose atTarget, noUp;
  atTarget.eye = atTarget.target;
  noUp.up = Vector(0);
  for (const PoseFlight& flight :
       {PoseFlight{atTarget, noUp}, PoseFlight{noUp, atTarget}, PoseFlight{noUp, noUp, 0}}) {
    const ViewPose pose = flight.poseAt(0.1);
    EXPECT_TRUE(isFinite(pose.eye) && isFinite(pose.target) && isFinite(pose.up));
  }
}

}  // namespace
}  // namespace anamorph
