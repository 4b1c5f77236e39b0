#include "math/uniform_spline.h"

#include <cmath>

#include <gtest/gtest.h>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

// As the definition has it.
double byDefinition(const std::vector<double>& c, std::size_t i, double u) {
  const std::size_t m = c.size();
  return ((1 - u) * (1 - u) * (1 - u) * c[i] + (3 * u * u * u - 6 * u * u + 4) * c[(i + 1) % m] +
          (-3 * u * u * u + 3 * u * u + 3 * u + 1) * c[(i + 2) % m] + u * u * u * c[(i + 3) % m]) /
         6;
}

TEST(UniformSpline, IsItsDefinition) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const bool closed = seed % 2 == 0;
    std::vector<double> c(static_cast<std::size_t>(random.integer(closed ? 3 : 4, 12)));
    for (double& value : c) value = random.uniform(-3, 3);
    const std::vector<Cubic> spans = splineSpans(c, closed);
    ASSERT_EQ(spans.size(), closed ? c.size() : c.size() - 3);
    for (std::size_t i = 0; i < spans.size(); ++i) {
      for (const double u : {0.0, 0.1, 0.5, 0.9, 1.0}) {
        const double slope = (byDefinition(c, i, u + 1e-6) - byDefinition(c, i, u - 1e-6)) / 2e-6;
        const auto at = valueAndSlope(spans[i], u);
        EXPECT_NEAR(at.value, byDefinition(c, i, u), 1e-14);
        EXPECT_NEAR(at.slope, slope, 1e-8);
        if (closed) continue;
        EXPECT_NEAR(splineAt(c, double(i) + u).value, at.value, 1e-14);
        EXPECT_NEAR(splineAt(c, double(i) + u).slope, at.slope, 1e-12);
      }
    }
  }
}

TEST(UniformSpline, PiecesAgreeAtTheKnotsToTheBit) {
  Random random(1);
  std::vector<double> c(9);
  for (double& value : c) value = random.uniform(-3, 3);
  const std::vector<Cubic> spans = splineSpans(c, true);
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const Cubic &one = spans[i], &next = spans[(i + 1) % spans.size()];
    EXPECT_EQ(one.c[3], next.c[0]);
    EXPECT_NEAR(one.c[3] - one.c[2], next.c[1] - next.c[0], 1e-15);
    EXPECT_NEAR(one.c[3] - 2 * one.c[2] + one.c[1], next.c[2] - 2 * next.c[1] + next.c[0], 1e-14);
  }
}

TEST(UniformSpline, TooFewControlValuesAreNone) {
  EXPECT_TRUE(splineSpans(std::vector<double>{1, 2, 3}).empty());
  EXPECT_TRUE(splineSpans(std::vector<double>{1, 2}, true).empty());
}

TEST(UniformSpline, OfALineIsTheLine) {
  const std::vector<double> line{-1, 0, 1, 2, 3, 4};
  const std::vector<Cubic> spans = splineSpans(line);
  for (double u = 0; u <= 3; u += 0.125) EXPECT_NEAR(splineAt(line, u).value, u, 1e-15);
  EXPECT_NEAR(rangeOf(spans).first, 0, 1e-15);
  EXPECT_NEAR(rangeOf(spans).second, 3, 1e-15);
}

}  // namespace
}  // namespace anamorph
