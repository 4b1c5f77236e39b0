#include "math/vec.h"

#include <gtest/gtest.h>

#include <limits>

#include "math/ray.h"

namespace anamorph {
namespace {

TEST(Vec, AnglesConvertBothWays) {
  EXPECT_DOUBLE_EQ(radians(180), pi);
  EXPECT_DOUBLE_EQ(degrees(pi / 2), 90);
  EXPECT_DOUBLE_EQ(degrees(radians(33)), 33);
}

TEST(Vec, FiniteMeansEveryCoordinate) {
  EXPECT_TRUE(isFinite({1e308, -1e308, 0}));
  for (const double bad :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_FALSE(isFinite({bad, 0, 0}));
    EXPECT_FALSE(isFinite({0, bad, 0}));
    EXPECT_FALSE(isFinite({0, 0, -bad}));
  }
}

TEST(Vec, LengthSquared) {
  EXPECT_EQ(lengthSquared({1, 2, -2}), 9);
}

TEST(Ray, GoesAlongItsDirection) {
  const Ray ray{{1, 2, 3}, {0, 0, -1}};
  EXPECT_EQ(ray.at(0), Point(1, 2, 3));
  EXPECT_EQ(ray.at(2.5), Point(1, 2, 0.5));
}

}  // namespace
}  // namespace anamorph
