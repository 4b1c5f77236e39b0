#include "math/bernstein.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

double binomial(int n, int k) {
  return k == 0 ? 1 : binomial(n - 1, k - 1) * n / k;
}

// Of a[0] + a[1] s + a[2] s^2 ...
template <int degree>
Bernstein<degree> fromPowers(const std::array<double, degree + 1>& a) {
  Bernstein<degree> p;
  for (int k = 0; k <= degree; ++k) {
    for (int i = 0; i <= k; ++i) {
      p.c[static_cast<std::size_t>(k)] +=
          binomial(k, i) / binomial(degree, i) * a[static_cast<std::size_t>(i)];
    }
  }
  return p;
}

// Of (s - roots[0]) (s - roots[1]) ..., in powers.
template <int degree>
Bernstein<degree> withRoots(const std::vector<double>& roots, double factor = 1) {
  std::array<double, degree + 1> a{};
  a[0] = factor;
  for (const double root : roots) {
    for (std::size_t i = degree; i > 0; --i) a[i] = a[i - 1] - root * a[i];
    a[0] *= -root;
  }
  return fromPowers<degree>(a);
}

TEST(Bernstein, IsThePolynomialOfItsPowers) {
  const std::array<double, 7> a{3, -1, 4, 1, -5, 9, -2};
  const Bernstein<6> p = fromPowers<6>(a);
  for (const double s : {0.0, 0.1, 0.5, 0.77, 1.0, -0.2, 1.3}) {
    double value = 0, slope = 0;
    for (std::size_t i = 7; i-- > 0;) {
      slope = slope * s + value;
      value = value * s + a[i];
    }
    EXPECT_NEAR(valueAndSlope(p, s).value, value, 1e-12);
    EXPECT_NEAR(valueAndSlope(p, s).slope, slope, 1e-11);
  }
}

TEST(Bernstein, PartsAreTheSamePolynomial) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Cubic p;
    for (double& c : p.c) c = random.uniform(-1, 1);
    const double from = random.uniform(-0.1, 1.1), to = seed % 10 == 0 ? from : random.uniform(-0.1, 1.1);
    const Cubic part = partOf(p, from, to);
    const auto [left, right] = split(p, 0.3);
    for (const double s : {0.0, 0.2, 0.5, 1.0}) {
      EXPECT_NEAR(valueAndSlope(part, s).value, valueAndSlope(p, from + s * (to - from)).value, 1e-14);
      EXPECT_NEAR(valueAndSlope(left, s).value, valueAndSlope(p, 0.3 * s).value, 1e-14);
      EXPECT_NEAR(valueAndSlope(right, s).value, valueAndSlope(p, 0.3 + 0.7 * s).value, 1e-14);
    }
  }
}

TEST(Bernstein, RangeOfACubicIsExact) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Cubic p;
    for (double& c : p.c) c = random.uniform(-1, 1);
    const auto [least, greatest] = rangeOf(p);
    double low = 1e9, high = -1e9;
    for (int i = 0; i <= 10000; ++i) {
      const double value = valueAndSlope(p, i / 10000.0).value;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    EXPECT_NEAR(least, low, 1e-7);
    EXPECT_NEAR(greatest, high, 1e-7);
    EXPECT_LE(least, low + 1e-15);
    EXPECT_GE(greatest, high - 1e-15);
  }
}

TEST(Bernstein, AlongTheDiagonalIsTheProduct) {
  std::array<Cubic, 4> g;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) g[i].c[j] = std::sin(double(5 * i + j + 1));
  }
  const Bernstein<6> p = alongDiagonal(g);
  for (const double s : {0.0, 0.3, 0.8, 1.0}) {
    Cubic along;
    for (std::size_t i = 0; i < 4; ++i) along.c[i] = valueAndSlope(g[i], s).value;
    EXPECT_NEAR(valueAndSlope(p, s).value, valueAndSlope(along, s).value, 1e-15);
  }
}

TEST(Crossings, AreAllOfThemInOrder) {
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    std::vector<double> roots(6);
    for (double& root : roots) root = random.uniform(-0.5, 1.5);
    std::sort(roots.begin(), roots.end());
    double closest = 1;
    for (std::size_t i = 1; i < 6; ++i) closest = std::min(closest, roots[i] - roots[i - 1]);
    if (closest < 0.01) continue;
    const Crossings<6> found = findCrossings(withRoots<6>(roots));
    std::vector<Crossing> wanted;
    for (std::size_t i = 0; i < 6; ++i) {
      if (roots[i] > 0 && roots[i] < 1) wanted.push_back({roots[i], i % 2 == 1});
    }
    ASSERT_EQ(found.count, wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      EXPECT_NEAR(found.all[i].at, wanted[i].at, 1e-8);  // of roots this near to each other
      EXPECT_EQ(found.all[i].rising, wanted[i].rising);
    }
  }
}

TEST(Crossings, OfSymmetricPolynomialsAreFoundWhereOthersSplit) {
  for (const double split : {0.5, 0.25, 0.492}) {
    SCOPED_TRACE(split);
    const Crossings<6> odd = findCrossings(withRoots<6>({split - 0.2, split, split + 0.2}));
    ASSERT_EQ(odd.count, 3u);
    EXPECT_NEAR(odd.all[1].at, split, 1e-14);
  }
  EXPECT_EQ(findCrossings(Cubic{{-1, 0, 0, 1}}).count, 1u);
  EXPECT_EQ(findCrossings(Cubic{{0, 0, 0, 0}}).count, 0u);
}

TEST(Crossings, TouchingIsNone) {
  for (const double at : {0.5, 0.25, 0.492, 0.3, 0.7}) {
    SCOPED_TRACE(at);
    EXPECT_EQ(findCrossings(withRoots<6>({at, at, 2})).count % 2, 0u) << "what crosses comes back";
    EXPECT_EQ(findCrossings(withRoots<6>({at, at, at, at, -1})).count % 2, 0u);
  }
  EXPECT_EQ(findCrossings(withRoots<2>({0.5, 0.5})).count, 0u);
  EXPECT_EQ(findCrossings(withRoots<2>({0.5, 0.5}, -1)).count, 0u);
  EXPECT_EQ(findCrossings(withRoots<6>({0.3, 0.3 + 1e-7})).count, 2u) << "near to each other, but two";
  const Crossings<6> triple = findCrossings(withRoots<6>({0.3, 0.3, 0.3}));
  ASSERT_EQ(triple.count % 2, 1u) << "it changes its sign";
  EXPECT_NEAR(triple.all[0].at, 0.3, 1e-4);
}

}  // namespace
}  // namespace anamorph
