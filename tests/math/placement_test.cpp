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

double matrixDifference(const glm::dmat3& a, const glm::dmat3& b) {
  return glm::length(a[0] - b[0]) + glm::length(a[1] - b[1]) + glm::length(a[2] - b[2]);
}

TEST(EulerDegrees, GiveTheSameRotation) {
  for (unsigned seed = 0; seed < 5000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    const auto number = [&](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const auto turns = [&] { return 90.0 * std::uniform_int_distribution<int>(-4, 4)(random); };
    const auto anyAngles = [&] {
      const double x = number(-400, 400), y = number(-400, 400);
      return Vector(x, y, number(-400, 400));
    };
    Vector angles = anyAngles();
    if (seed % 3 == 0) angles.y = turns();                             // gimbal lock
    if (seed % 3 == 1) angles.y = 90 + std::pow(10, number(-14, -3));  // or nearly so
    if (seed % 4 == 0) angles.x = turns(), angles.z = turns();
    const glm::dmat3 rotation = rotationMatrix(angles);
    const Vector found = eulerDegrees(rotation, anyAngles());
    EXPECT_LT(matrixDifference(rotationMatrix(found), rotation), 1e-10);
    // Near the angles that made it, they are found again (where they are unique).
    const Vector again = eulerDegrees(rotation, angles);
    if (std::abs(std::cos(radians(angles.y))) > 1e-3) {
      EXPECT_LT(glm::length(again - angles), 1e-8);
    }
    EXPECT_LT(matrixDifference(rotationMatrix(again), rotation), 1e-10);
  }
}

TEST(EulerDegrees, StayNearWhileTurning) {
  Vector angles(0);
  for (int i = 0; i < 720; ++i) {  // twice around z: 720 degrees, not back to 0
    angles = eulerDegrees(rotationMatrix({0, 0, 1}) * rotationMatrix(angles), angles);
  }
  EXPECT_LT(glm::length(angles - Vector(0, 0, 720)), 1e-6);
}

}  // namespace
}  // namespace anamorph
