#include "optics/revolution.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optics/cone.h"
#include "optics/cylinder.h"
#include "optics/random_splines.h"

namespace anamorph {
namespace {

using namespace testing;

// A ray at a shape that stands near the origin, from anywhere.
Ray randomRay(Random& random) {
  const Point eye = random.uniform(8, 30) * random.direction();
  return {eye, random.point(3) - eye};
}

void expectSameHit(const Shape& one, const Shape& other, const Ray& ray) {
  const auto a = intersect(one, ray), b = intersect(other, ray);
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_NEAR(a->t, b->t, 1e-12);
  EXPECT_LT(glm::length(a->normal - b->normal), 1e-11);
}

// Fact G7.
TEST(Revolution, OfEqualRadiiIsTheCylinder) {
  int hits = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Point bottom = random.point(1), top = random.point(3);
    const double radius = random.uniform(0.5, 3);
    const std::vector<double> radii(static_cast<std::size_t>(random.integer(4, 12)), radius);
    const Ray ray = randomRay(random);
    const CylinderMirror tube{bottom, top, radius};
    hits += intersect(tube, ray).has_value();
    expectSameHit(RevolutionMirror{bottom, top, radii}, tube, ray);
  }
  EXPECT_GT(hits, 600);
}

TEST(Revolution, OfRadiiInALineIsTheCone) {
  int hits = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Point bottom = random.point(1), top = random.point(3);
    const double r0 = random.uniform(0.5, 3), r1 = random.uniform(0.5, 3);
    const int spans = random.integer(1, 9);
    std::vector<double> radii;
    for (int i = -1; i <= spans + 1; ++i) radii.push_back(r0 + (r1 - r0) * i / spans);
    const Ray ray = randomRay(random);
    const ConeMirror cone{bottom, top, r0, r1};
    hits += intersect(cone, ray).has_value();
    expectSameHit(RevolutionMirror{bottom, top, radii}, cone, ray);
  }
  EXPECT_GT(hits, 600);
}

TEST(Revolution, IsMetFromEverySideAndAlongItsAxis) {
  const RevolutionMirror vase;  // widest at half its height or below, narrowest near its top
  const double middle = glm::length(vase.pointAt(0, 0.5) - Point(0, 0, 4));
  const auto across = intersect(vase, {{0, -9, 4}, {0, 1, 0}});
  ASSERT_TRUE(across);
  EXPECT_NEAR(across->t, 9 - middle, 1e-13) << "a level ray, at a knot";
  const auto inside = intersect(vase, {{0, 0, 4}, {1, 0, 0}});
  ASSERT_TRUE(inside);
  EXPECT_NEAR(inside->t, middle, 1e-13);
  EXPECT_LT(inside->normal.x, 0);
  EXPECT_FALSE(intersect(vase, {{0, 0, 20}, {0, 0, -1}})) << "down its axis";
  EXPECT_FALSE(intersect(vase, {{1.5, 0, 20}, {0, 0, -1}})) << "down inside its neck";
  EXPECT_FALSE(intersect(vase, {{3.3, 0, 20}, {0, 0, -1}})) << "down beside it";
  const auto shoulder = intersect(vase, {{2.6, 0, 20}, {0, 0, -1}});
  ASSERT_TRUE(shoulder) << "down on its shoulder";
  EXPECT_GT(shoulder->normal.z, 0);
  EXPECT_FALSE(intersect(vase, {{0, -9, 8.001}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(vase, {{0, -9, -0.001}, {0, 1, 0}}));
  // Nearly level and nearly along the axis, where knots are far away on the ray.
  for (const double slope : {1e-3, 1e-8, 1e-13, 1e-17, 1e-200}) {
    const auto hit = intersect(vase, {{0, -9, 4}, {0, 1, slope}});
    ASSERT_TRUE(hit) << slope;
    EXPECT_NEAR(hit->t, across->t, 10 * slope + 1e-13);
    EXPECT_FALSE(intersect(vase, {{0, 0, 20}, {0, slope, -1}}).has_value() && slope < 1e-4) << slope;
  }
}

TEST(Revolution, IsAsWideSeenFromAboveAsItsWidestPlace) {
  RevolutionMirror vase;
  double widest = 0;
  for (int i = 0; i <= 10000; ++i) widest = std::max(widest, vase.pointAt(0, i / 10000.0).x);
  ASSERT_TRUE(vase.circleFromAbove());
  EXPECT_NEAR(*vase.circleFromAbove(), std::max(widest, vase.widest()), 1e-6);
  EXPECT_LT(vase.widest(), 3.1) << "not its control value";
  vase.top.x = 1;
  EXPECT_FALSE(vase.circleFromAbove());
}

TEST(Revolution, ProblemsAreNamed) {
  const Point a(0, 0, 0), b(0, 0, 6);
  const struct {
    RevolutionMirror mirror;
    const char* message;
  } table[] = {
      {{a, b, {1, 1, 1}}, "expected at least 4 radii, got 3"},
      {{a, a, {1, 1, 1, 1}}, "expected a top that is not at the bottom, got a turned profile of height 0"},
      {{a, b, {1, 1, -2, 1, 1}},
       "expected a radius > 0 all over the profile, got -1 between the heights 0 and 3"},
      {{a, b, {1, 1, 1, 1, 1, -3, 1}},
       "expected a radius > 0 all over the profile, got -1.67 between the heights 4.5 and 6"},
      {{a, b, {1, std::nan(""), 1, 1}},
       "expected a radius > 0 all over the profile, got nan between the heights 0 and 6"},
  };
  for (const auto& row : table) EXPECT_EQ(row.mirror.findProblem().value_or(""), row.message);
  EXPECT_EQ(RevolutionMirror{}.findProblem(), std::nullopt);
  // Between two knots, where neither end is.
  EXPECT_EQ((RevolutionMirror{a, b, {5, -0.8, -0.8, 5}}.findProblem().value_or("")),
            "expected a radius > 0 all over the profile, got -0.558 between the heights 0 and 6");
  // A control value may be below 0 where the profile is not.
  EXPECT_EQ((RevolutionMirror{a, b, {-0.5, 1, 1, 1}}.findProblem()), std::nullopt);
}

}  // namespace
}  // namespace anamorph
