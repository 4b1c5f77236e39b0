#include "optics/paraboloid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optics/optic.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using namespace testing;

// Fact G3: from the focus to parallel; and back.
TEST(Paraboloid, MakesRaysFromItsFocusParallel) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomScene scene = makeRandomScene(ShapeKind::paraboloid, random);
    const auto& bowl = shapeAs<ParaboloidMirror>(scene.optic.shape());
    const Direction axis = glm::normalize(bowl.axis);
    const Point focus = bowl.vertex + bowl.focalLength * axis;
    const OpticPath path = followRay(scene.optic, {focus, glm::normalize(scene.onMirror - focus)});
    ASSERT_EQ(path.pointCount, 1);
    EXPECT_LT(glm::length(path.points[0] - scene.onMirror), 1e-12);
    EXPECT_LT(glm::length(path.exit.direction - axis), 1e-13);
    EXPECT_EQ(freeLength(scene.optic, path), std::numeric_limits<double>::infinity());

    const OpticPath back = followRay(scene.optic, {scene.onMirror + 3.0 * axis, -axis});
    ASSERT_EQ(back.pointCount, 1);
    EXPECT_LT(glm::length(glm::cross(focus - back.points[0], back.exit.direction)), 1e-12);
  }
}

TEST(Paraboloid, IsMetAtItsVertexAndNotInItsHole) {
  const ParaboloidMirror whole{{0, 0, 0}, {0, 0, 5}, 1, 2, 0}, ring{{0, 0, 0}, {0, 0, 5}, 1, 2, 0.5};
  const Ray down{{0, 0, 3}, {0, 0, -1}}, up{{0, 0, -3}, {0, 0, 1}};
  for (const Ray& ray : {down, up}) {
    const auto hit = intersect(whole, ray);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->point, Point(0));
    EXPECT_EQ(hit->normal, -ray.direction);
    EXPECT_FALSE(intersect(ring, ray));
  }
  EXPECT_TRUE(intersect(ring, {{0.6, 0, 3}, {0, 0, -1}}));
  EXPECT_FALSE(intersect(whole, {{2.1, 0, 3}, {0, 0, -1}})) << "beyond the rim";
}

TEST(Paraboloid, FitsItsBox) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = makeRandomScene(ShapeKind::paraboloid, random).optic.shape();
    const Box exact = boxOf(shape), seen = boundingBox(tessellate(shape, 400).mesh.positions);
    EXPECT_LT(glm::length(exact.min - seen.min) + glm::length(exact.max - seen.max), 4e-3 * exact.diagonal());
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(exact.min[i], seen.min[i] + 1e-12);
      EXPECT_GE(exact.max[i], seen.max[i] - 1e-12);
    }
  }
}

TEST(Paraboloid, KeepsItsFormWhenItIsScaled) {
  const Shape bowl = ParaboloidMirror{{1, 2, 3}, {0, 0, 2}, 2, 4, 1};
  const auto scaled = [&](const Vector& f) {
    return shapeAs<ParaboloidMirror>(mapShape(bowl, {[&](const Point& p) { return f * p; }, f}));
  };
  EXPECT_EQ(scaled({1, 1, 1}), shapeAs<ParaboloidMirror>(bowl));
  EXPECT_EQ(scaled({2, 2, 2}), (ParaboloidMirror{{2, 4, 6}, {0, 0, 2}, 4, 8, 2}));
  EXPECT_EQ(scaled({1, 1, 2}), (ParaboloidMirror{{1, 2, 6}, {0, 0, 2}, 1, 4, 1})) << "twice as deep";
  EXPECT_EQ(scaled({2, 2, 1}), (ParaboloidMirror{{2, 4, 3}, {0, 0, 2}, 8, 8, 2})) << "as deep, twice as wide";
}

}  // namespace
}  // namespace anamorph
