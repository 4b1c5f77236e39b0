#include "math/placement.h"

#include <gtest/gtest.h>

#include <random>

namespace anamorph {
namespace {

void expectNear(const Point& a, const Point& b) {
  EXPECT_NEAR(glm::length(a - b), 0, 1e-12);
}

TEST(Placement, ANewOneLeavesPointsExactlyAlone) {
  const Point p(0.1, -0.2, 0.3);
  EXPECT_EQ(PlacementMap(Placement{})(p), p);
}

TEST(Placement, AMoveAloneIsExactlyASum) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> number(-1e3, 1e3);
  for (int i = 0; i < 1000; ++i) {
    const Point position(number(random), number(random), number(random));
    const Point p(number(random), number(random), number(random));
    ASSERT_EQ(PlacementMap({.position = position})(p), position + p) << i;
  }
}

TEST(Placement, TurnsCounterClockwiseAboutEachAxis) {
  expectNear(rotationMatrix({90, 0, 0}) * Vector(0, 1, 0), {0, 0, 1});
  expectNear(rotationMatrix({0, 90, 0}) * Vector(0, 0, 1), {1, 0, 0});
  expectNear(rotationMatrix({0, 0, 90}) * Vector(1, 0, 0), {0, 1, 0});
  expectNear(rotationMatrix({90, 0, 0}) * Vector(1, 0, 0), {1, 0, 0});
  expectNear(rotationMatrix({0, 90, 0}) * Vector(0, 1, 0), {0, 1, 0});
  expectNear(rotationMatrix({0, 0, 90}) * Vector(0, 0, 1), {0, 0, 1});
}

TEST(Placement, TurnsAboutXFirstThenYThenZ) {
  // About x: (0, 1, 0) -> (0, 0, 1); about y: -> (1, 0, 0); about z: -> (0, 1, 0). Any other order ends
  // elsewhere.
  expectNear(rotationMatrix({90, 90, 90}) * Vector(0, 1, 0), {0, 1, 0});
  expectNear(rotationMatrix({90, 90, 0}) * Vector(0, 1, 0), {1, 0, 0});
  expectNear(rotationMatrix({90, 0, 90}) * Vector(0, 1, 0), {0, 0, 1});
  const Vector angles(20, -50, 110);
  const glm::dmat3 inOrder =
      rotationMatrix({0, 0, angles.z}) * rotationMatrix({0, angles.y, 0}) * rotationMatrix({angles.x, 0, 0});
  const Vector v(1, 2, 3);
  expectNear(rotationMatrix(angles) * v, inOrder * v);
}

TEST(Placement, RotationsKeepLengthAndHandedness) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angle(-720, 720);
  for (int i = 0; i < 1000; ++i) {
    const glm::dmat3 m = rotationMatrix({angle(random), angle(random), angle(random)});
    ASSERT_NEAR(glm::length(m[0]), 1, 1e-14) << i;
    ASSERT_NEAR(glm::dot(m[0], m[1]), 0, 1e-14) << i;
    ASSERT_NEAR(glm::length(glm::cross(m[0], m[1]) - m[2]), 0, 1e-14) << i;
  }
}

TEST(Placement, ScalesBeforeItTurnsAndTurnsBeforeItMoves) {
  const PlacementMap map({.position = {10, 20, 30}, .rotationDegrees = {0, 0, 90}, .scale = {2, 3, 4}});
  expectNear(map({1, 0, 0}), {10, 22, 30});
  expectNear(map({0, 1, 0}), {7, 20, 30});
  expectNear(map({0, 0, 1}), {10, 20, 34});
}

TEST(Placement, ComparesByValue) {
  EXPECT_EQ(Placement{}, Placement{});
  EXPECT_NE(Placement{}, (Placement{.scale = Vector(2)}));
}

}  // namespace
}  // namespace anamorph
