// What the mirrors of splines have in common beside rays: boxes, normals, borders, and how they are moved and described.

#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "optics/random_splines.h"
#include "optics/shape.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(Splines, BoxContainsTheSurfaceAndTouchesIt) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Box box = boxOf(shape), samples = boundingBox(tessellate(shape, 200).mesh.positions);
    const double size = box.diagonal();
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(box.min[k], samples.min[k] + 1e-12 * size);
      EXPECT_GE(box.max[k], samples.max[k] - 1e-12 * size);
      EXPECT_NEAR(box.min[k], samples.min[k], 2e-3 * size);
      EXPECT_NEAR(box.max[k], samples.max[k], 2e-3 * size);
    }
  }
}

TEST(Splines, NormalsAreThoseOfTheSurface) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const double u = random.uniform(0.01, 0.99), v = random.uniform(0.01, 0.99), e = 1e-5;
    const Aim aim = aimAt(shape, u, v);
    const Vector alongU = pointAt(shape, u + e, v) - pointAt(shape, u - e, v);
    const Vector alongV = pointAt(shape, u, v + e) - pointAt(shape, u, v - e);
    EXPECT_LT(glm::length(glm::normalize(glm::cross(alongU, alongV)) - aim.normal), 1e-6) << "outwards";
    // The hit has the same one.
    const Direction way = wayTo(aim, random);
    const auto hit = intersect(shape, {aim.point - 0.01 * way, way});
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::length(hit->point - aim.point), 1e-11);
    EXPECT_LT(glm::length(hit->normal - facing(aim.normal, way)), 1e-9);
  }
}

TEST(Splines, BordersAreAtTheirBorders) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const auto* wall = shape.as<ExtrusionMirror>();
    const double w = random.uniform(0, 1);
    const bool sides = shape.as<PatchMirror>() || (wall && !wall->closed);
    for (const double end : {0.0, 1.0}) {
      EXPECT_NEAR(borderDistance(shape, pointAt(shape, w, end)), 0, 1e-12);
      if (sides) {
        EXPECT_NEAR(borderDistance(shape, pointAt(shape, end, w)), 0, 1e-12);
      }
    }
    const double middle = borderDistance(shape, pointAt(shape, 0.5, 0.5));
    EXPECT_GT(middle, 0.02);
    EXPECT_LE(middle, 0.5 + 1e-12);
    if (!sides) {
      EXPECT_GT(borderDistance(shape, pointAt(shape, 0, 0.5)), 0.02) << "a seam is no border";
    }
  }
}

TEST(Splines, AreMovedTurnedAndScaledAsTheirPointsAre) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const double u = random.uniform(0, 1), v = random.uniform(0, 1);
    const Point p = pointAt(shape, u, v);
    const Vector shift = random.point(3);
    const Shape moved = mapShape(shape, {[&](const Point& q) { return q + shift; }});
    EXPECT_LT(glm::length(pointAt(moved, u, v) - (p + shift)), 1e-12 * 40);
    if (const auto* wall = shape.as<ExtrusionMirror>()) {
      EXPECT_EQ(shapeAs<ExtrusionMirror>(moved).axis, wall->axis) << "to the bit";
      EXPECT_EQ(shapeAs<ExtrusionMirror>(moved).across, wall->across);
    }
    const auto turn = [](const Point& q) { return Point(q.y, q.z, q.x); };
    const Shape turned = mapShape(shape, {turn});
    if (!shape.as<RevolutionMirror>()) {
      EXPECT_LT(glm::length(pointAt(turned, u, v) - turn(p)), 1e-11);
    }
    EXPECT_LT(glm::length(middleOf(turned) - turn(middleOf(shape))), 1e-11);
    const Shape larger = mapShape(shape, {[](const Point& q) { return 2.0 * q; }, Vector(2)});
    EXPECT_LT(glm::length(pointAt(larger, u, v) - 2.0 * p), 1e-11);
    EXPECT_EQ(findShapeProblem(larger), findShapeProblem(shape));
  }
}

// Factors along its own axes.
TEST(Splines, AreScaledAlongTheirOwnAxes) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Vector factors = shape.as<RevolutionMirror>() ? Vector(2, 2, 0.5) : Vector(2, 0.5, 1.5);
    const Axes axes = axesOf(shape);
    const auto scale = [&](const Point& q) {
      Point scaled(0);
      for (int k = 0; k < 3; ++k)
        scaled += factors[k] * glm::dot(q, axes[std::size_t(k)]) * axes[std::size_t(k)];
      return scaled;
    };
    const Shape scaled = mapShape(shape, {scale, factors});
    for (const auto& [u, v] : {std::pair{0.1, 0.3}, {0.5, 0.9}, {0.8, 0.0}}) {
      EXPECT_LT(glm::length(pointAt(scaled, u, v) - scale(pointAt(shape, u, v))), 1e-11);
    }
  }
}

TEST(Splines, CarriedOnHoldTheOldSurface) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    if (const auto* wall = shape.as<ExtrusionMirror>(); wall && wall->closed) continue;  // it grows
    const Shape whole = continued(shape);
    EXPECT_GT(boxOf(whole).diagonal(), 1.02 * boxOf(shape).diagonal());
    const Aim aim = aimAt(shape, random.uniform(0, 1), random.uniform(0.01, 0.99));
    const Direction way = wayTo(aim, random);
    const auto hit = intersect(whole, {aim.point - 0.01 * way, way});
    ASSERT_TRUE(hit);
    EXPECT_LT(glm::length(hit->point - aim.point), 1e-9);
  }
}

TEST(Splines, EyesOnThemAreNamedAndMovedAway) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = randomSpline(int(seed), random);
    const Aim aim = aimAt(shape, random.uniform(0, 1), random.uniform(0, 1));
    EXPECT_EQ(findEyeProblem(shape, aim.point).value_or(""),
              "the eye is on the surface of the mirror, from where nothing is seen in it. Move the eye away "
              "from the "
              "surface, to either side.");
    EXPECT_EQ(findEyeProblem(shape, aim.point + 1e-3 * aim.normal), std::nullopt);
    EXPECT_EQ(findEyeProblem(shape, eyeOutside(shape, aim.point, aim.point - aim.normal)), std::nullopt);
    const Point far = 1e8 * random.direction();
    EXPECT_THAT(findEyeProblem(shape, far).value_or(""),
                ::testing::HasSubstr("is too small for an eye that is"));
    EXPECT_EQ(findEyeProblem(shape, eyeOutside(shape, far, middleOf(shape))), std::nullopt);
  }
}

TEST(Splines, DescribeThemselvesInAFewLines) {
  const LengthText text = [](double length) { return std::to_string(std::lround(length)); };
  for (unsigned seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const ShapeWords words = randomSpline(int(seed), random)->words(text);
    EXPECT_LT(words.size.size(), 400u) << words.size;
    EXPECT_FALSE(words.stance.empty());
  }
}

}  // namespace
}  // namespace anamorph
