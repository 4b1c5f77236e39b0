#include "optics/patch.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optics/plane.h"
#include "optics/random_splines.h"

namespace anamorph {
namespace {

using namespace testing;

// Fact G7: heights that grow evenly along both sides.
TEST(Patch, OfEvenHeightsIsThePlane) {
  int hits = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    PatchMirror patch = randomPatch(random);
    const double start = random.uniform(-2, 2), alongX = random.uniform(-1, 1),
                 alongY = random.uniform(-1, 1);
    const std::size_t columns = patch.heights.columns, rows = patch.heights.rows();
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t column = 0; column < columns; ++column) {
        patch.heights.at(row, column) = start + alongX * double(column) + alongY * double(row);
      }
    }
    const PlaneMirror plane{
        {patch.pointAt(0, 0), patch.pointAt(1, 0), patch.pointAt(1, 1), patch.pointAt(0, 1)}};
    ASSERT_EQ(plane.findProblem(), std::nullopt);
    const Point eye = random.uniform(8, 30) * random.direction();
    const Ray ray{eye, plane.middle() + random.point(4) - eye};
    const auto a = intersect(Shape(patch), ray), b = intersect(plane, ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    ++hits;
    EXPECT_NEAR(a->t, b->t, 1e-12 / std::abs(glm::dot(b->normal, glm::normalize(ray.direction))));
    EXPECT_LT(glm::length(a->normal - b->normal), 1e-12);
  }
  EXPECT_GT(hits, 600);
}

TEST(Patch, IsMetThroughKnotsAndAlongItsFrame) {
  const PatchMirror patch;  // upright, symmetric, towards y < 0: X = x, Y = z, Z = -y
  for (const double x : {-6.0, -4.0, -2.0, 0.0, 2.0, 3.0, 6.0}) {
    for (const double z : {0.0, 8.0 / 3, 4.0, 16.0 / 3, 8.0}) {
      SCOPED_TRACE(std::to_string(x) + ", " + std::to_string(z));
      const auto hit = intersect(Shape(patch), {{x, -9, z}, {0, 1, 0}});
      ASSERT_TRUE(hit) << "the border is included";
      EXPECT_NEAR(hit->point.y, -heightByDefinition(patch, x + 6, z), 1e-14);
    }
  }
  EXPECT_FALSE(intersect(Shape(patch), {{6.001, -9, 4}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(Shape(patch), {{0, -9, -0.001}, {0, 1, 0}}));
  // Along its plane, just under the top of the bulge: from both sides, at the same places.
  const double top = -patch.pointAt(0.5, 0.5).y;
  for (const Vector& along : {Vector(1, 0, 0), Vector(0, 0, 1), Vector(1, 0, 1)}) {
    const Point middle(0, -0.9 * top, 4);
    const Ray ray{middle - 20.0 * along, along}, back{middle + 20.0 * along, -along};
    const auto there = intersect(Shape(patch), ray), here = intersect(Shape(patch), back);
    ASSERT_TRUE(there && here);
    EXPECT_NEAR(there->t, here->t, 1e-12);
    const auto out = intersect(Shape(patch), ray, there->t);
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->t, 40 - here->t, 1e-12);
    EXPECT_FALSE(intersect(Shape(patch), ray, out->t));
  }
}

TEST(Patch, BoxOfATiltedLargeOneIsNotMuchTooLarge) {
  Random random(4);
  PatchMirror patch = randomPatch(random);
  patch.heights.columns = 64;
  patch.heights.heights.resize(64 * 64);
  for (double& h : patch.heights.heights) h = random.uniform(-0.1, 0.1);
  const Box box = patch.box();
  Box samples;
  for (int i = 0; i <= 610; ++i) {
    for (int j = 0; j <= 610; ++j) samples.extend(patch.pointAt(i / 610.0, j / 610.0));
  }
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(box.min[k], samples.min[k], 1e-3);
    EXPECT_NEAR(box.max[k], samples.max[k], 1e-3);
    EXPECT_LE(box.min[k], samples.min[k] + 1e-12);
    EXPECT_GE(box.max[k], samples.max[k] - 1e-12);
  }
}

TEST(Patch, ProblemsAreNamed) {
  const auto patch = [](auto change) {
    PatchMirror made;
    change(made);
    return made;
  };
  const struct {
    PatchMirror mirror;
    const char* message;
  } table[] = {
      {patch([](PatchMirror& p) {
         p.heights = {3, std::vector<double>(15)};
       }),
       "expected at least 4 rows of at least 4 heights, got 5 rows of 3"},
      {patch([](PatchMirror& p) {
         p.heights = {5, std::vector<double>(15)};
       }),
       "expected at least 4 rows of at least 4 heights, got 3 rows of 5"},
      {patch([](PatchMirror& p) { p.heights = {}; }),
       "expected at least 4 rows of at least 4 heights, got 0 rows of 0"},
      {patch([](PatchMirror& p) { p.size[0] = 0; }), "expected a width > 0, got 0"},
      {patch([](PatchMirror& p) { p.size[1] = -2; }), "expected a height > 0, got -2"},
      {patch([](PatchMirror& p) { p.across = Vector(0); }), "expected a direction across that is not 0"},
      {patch([](PatchMirror& p) { p.up = 2.0 * p.across; }),
       "expected a direction up that is not along the one across"},
  };
  for (const auto& row : table) EXPECT_EQ(row.mirror.findProblem().value_or(""), row.message);
  EXPECT_EQ(PatchMirror{}.findProblem(), std::nullopt);
}

}  // namespace
}  // namespace anamorph
