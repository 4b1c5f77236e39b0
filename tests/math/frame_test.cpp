#include "math/frame.h"

#include <gtest/gtest.h>

#include <random>

namespace anamorph {
namespace {

Direction randomDirection(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const double x = normal(random), y = normal(random);
  return glm::normalize(Vector(x, y, normal(random)));
}

void expectOrthonormal(const Frame& frame) {
  EXPECT_NEAR(glm::length(frame.right), 1, 1e-14);
  EXPECT_NEAR(glm::length(frame.up), 1, 1e-14);
  EXPECT_NEAR(glm::length(frame.forward), 1, 1e-14);
  EXPECT_NEAR(glm::length(glm::cross(frame.right, frame.up) + frame.forward), 0, 1e-14);
}

TEST(Frame, DefaultIsOrthonormal) {
  expectOrthonormal(Frame{});
}

TEST(Frame, LooksAlongForwardWithUpAsNearlyUpAsCanBe) {
  const unsigned seed = 5;
  std::mt19937 random(seed);
  for (int i = 0; i < 2000; ++i) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", case " << i);
    const Direction forward = randomDirection(random), up = randomDirection(random);
    const Frame frame = makeFrame(forward, up);
    expectOrthonormal(frame);
    EXPECT_EQ(frame.forward, forward);
    EXPECT_GT(glm::dot(frame.up, up), 0);
    EXPECT_NEAR(glm::dot(frame.right, up), 0, 1e-13);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Frame, LookingNorthWithZUpPutsEastRight) {
  const Frame frame = makeFrame({0, 1, 0}, {0, 0, 1});
  EXPECT_EQ(frame.right, Direction(1, 0, 0));
  EXPECT_EQ(frame.up, Direction(0, 0, 1));
}

TEST(Frame, StaysOrthonormalWhenUpIsAlongForward) {
  for (const Direction& d : {Direction(0, 0, 1), Direction(0, 0, -1), Direction(1, 0, 0), Direction(0, 1, 0),
                             glm::normalize(Vector(1, 2, 3)), glm::normalize(Vector(-5, 0.1, 1))}) {
    expectOrthonormal(makeFrame(d, d));
    expectOrthonormal(makeFrame(d, -d));
    for (const double lean : {1e-15, 1e-12, 1e-9, 1e-8, 1e-5, 1e-2}) {
      SCOPED_TRACE(testing::Message() << "lean " << lean);
      expectOrthonormal(makeFrame(d, glm::normalize(d + lean * perpendicular(d))));
    }
  }
}

TEST(Perpendicular, IsAUnitVectorAtARightAngle) {
  std::mt19937 random(6);
  for (int i = 0; i < 2000; ++i) {
    const Direction d = randomDirection(random);
    ASSERT_NEAR(glm::dot(perpendicular(d), d), 0, 1e-15) << i;
    ASSERT_NEAR(glm::length(perpendicular(d)), 1, 1e-15) << i;
  }
}

}  // namespace
}  // namespace anamorph
