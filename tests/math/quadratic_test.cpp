#include "math/quadratic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace anamorph {
namespace {

TEST(Quadratic, KnownRootsInAscendingOrder) {
  const auto roots = solveQuadratic(1, -2.5, 6);  // (t - 2)(t - 3)
  ASSERT_TRUE(roots);
  EXPECT_DOUBLE_EQ(roots->first, 2);
  EXPECT_DOUBLE_EQ(roots->second, 3);
  const auto negative = solveQuadratic(2, 5, 12);  // 2 (t + 2)(t + 3)
  ASSERT_TRUE(negative);
  EXPECT_DOUBLE_EQ(negative->first, -3);
  EXPECT_DOUBLE_EQ(negative->second, -2);
}

TEST(Quadratic, ZeroCoefficients) {
  EXPECT_EQ(*solveQuadratic(1, 0, -4), (std::pair{-2.0, 2.0}));
  EXPECT_EQ(*solveQuadratic(1, -0.0, -4), (std::pair{-2.0, 2.0}));
  EXPECT_EQ(*solveQuadratic(1, -3, 0), (std::pair{0.0, 6.0}));
  EXPECT_EQ(*solveQuadratic(1, 3, 0), (std::pair{-6.0, 0.0}));
  EXPECT_EQ(*solveQuadratic(1, 0, 0), (std::pair{0.0, 0.0}));
  EXPECT_EQ(*solveQuadratic(1, 2, 4), (std::pair{-2.0, -2.0}));
}

TEST(Quadratic, NothingWithoutRealRootsOrWithoutASquare) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(solveQuadratic(1, 0, 1));
  EXPECT_FALSE(solveQuadratic(0, 1, 1));
  EXPECT_FALSE(solveQuadratic(-1, 1, 1));
  EXPECT_FALSE(solveQuadratic(nan, 1, 1));
  EXPECT_FALSE(solveQuadratic(1, nan, 1));
  EXPECT_FALSE(solveQuadratic(1, 1, nan));
}

TEST(Quadratic, NoDigitsAreLostBetweenANearAndAFarRoot) {
  // A grazing distance of 1e-8 beside one of 1e8: the textbook formula returns 0 for the first.
  const auto roots = solveQuadratic(1, -0.5 * (1e8 + 1e-8), 1);
  ASSERT_TRUE(roots);
  EXPECT_NEAR(roots->first, 1e-8, 1e-22);
  EXPECT_DOUBLE_EQ(roots->second, 1e8);
}

TEST(Quadratic, AgreesWithLongDoubleOnRandomRoots) {
  const unsigned seed = 11;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-6, 6), sign(-1, 1);
  const auto number = [&] { return std::copysign(std::pow(10, exponent(random)), sign(random)); };
  for (int i = 0; i < 20000; ++i) {
    const double a = std::abs(number()), r = number(), s = number();
    const double halfB = -0.5 * a * (r + s), c = a * r * s;
    const long double la = a, lb = halfB, lc = c;
    const long double discriminant = lb * lb - la * lc;
    if (!(discriminant > 1e-6L * lb * lb)) continue;  // near a double root both are ill-conditioned
    const auto roots = solveQuadratic(a, halfB, c);
    ASSERT_TRUE(roots) << "seed " << seed << ", case " << i;
    const long double q = -(lb + std::copysign(std::sqrt(discriminant), lb));
    const long double low = std::min(q / la, lc / q), high = std::max(q / la, lc / q);
    ASSERT_NEAR(static_cast<double>(roots->first / low), 1, 1e-9) << "seed " << seed << ", case " << i;
    ASSERT_NEAR(static_cast<double>(roots->second / high), 1, 1e-9) << "seed " << seed << ", case " << i;
    // Where the roots are well apart nothing but rounding is left.
    if (discriminant > 0.25L * lb * lb) {
      ASSERT_NEAR(static_cast<double>(roots->first / low), 1, 4e-15) << "seed " << seed << ", case " << i;
      ASSERT_NEAR(static_cast<double>(roots->second / high), 1, 4e-15) << "seed " << seed << ", case " << i;
    }
  }
}

}  // namespace
}  // namespace anamorph
