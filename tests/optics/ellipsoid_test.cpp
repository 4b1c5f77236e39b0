#include "optics/ellipsoid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optics/optic.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using namespace testing;

// Fact G3: from focus to focus, by ways of one length.
TEST(Ellipsoid, SendsEveryRayFromOneFocusToTheOther) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const double across = random.uniform(0.5, 2), along = across * random.uniform(1, 5);
    const EllipsoidMirror mirror{random.point(5), {across, along, across}, random.point(180)};
    const Vector toFocus = std::sqrt(along * along - across * across) * mirror.axes()[1];
    const Point from = mirror.centre - toFocus, to = mirror.centre + toFocus;
    const Direction direction = random.direction();
    const OpticPath path = followRay({OpticKind::mirror, mirror}, {from, direction});
    ASSERT_EQ(path.pointCount, 1);
    const Vector onward = to - path.points[0];
    EXPECT_LT(glm::length(glm::cross(onward, path.exit.direction)), 1e-13 * along);
    EXPECT_NEAR(path.travelled + glm::length(onward), 2 * along, 1e-14 * along);
  }
}

// Fact G7.
TEST(Ellipsoid, WithEqualRadiiIsTheSphere) {
  for (const bool hollow : {false, true}) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(seed);
      const RandomScene scene =
          hollow ? makeHollowScene(ShapeKind::sphere, random) : makeRandomScene(ShapeKind::sphere, random);
      const auto& sphere = shapeAs<SphereMirror>(scene.optic.shape());
      const Optic same{OpticKind::mirror,
                       EllipsoidMirror{sphere.centre, Vector(sphere.radius), random.point(180)}};
      const Point p = makeRandomOriginal(scene, random, 0.3);
      const Ray ray{scene.eye, p - scene.eye};
      const OpticPath a = followRay(scene.optic, ray), b = followRay(same, ray);
      ASSERT_EQ(a.pointCount, b.pointCount);
      if (a.pointCount == 0 || a.sine < 0.1) continue;
      const double exitLength = random.uniform(0.1, 2) * (1 - a.travelled);
      EXPECT_LT(glm::length(a.exit.at(exitLength) - b.exit.at(exitLength)),
                1e-12 * (1 + glm::length(p - scene.eye)));
      EXPECT_EQ(seesConvexSide(scene.optic.shape(), scene.eye), seesConvexSide(same.shape(), scene.eye));
      EXPECT_EQ(statusOf(scene.optic, a, exitLength), statusOf(same, b, exitLength));
    }
  }
}

TEST(Ellipsoid, FitsItsBoxAndItsOutline) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = makeRandomScene(ShapeKind::ellipsoid, random).optic.shape();
    const Box exact = boxOf(shape), seen = boundingBox(tessellate(shape, 200).mesh.positions);
    EXPECT_LT(glm::length(exact.min - seen.min) + glm::length(exact.max - seen.max), 4e-3 * exact.diagonal());
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(exact.min[i], seen.min[i] + 1e-12);
      EXPECT_GE(exact.max[i], seen.max[i] - 1e-12);
    }
  }
  EXPECT_EQ(circleFromAbove(EllipsoidMirror{{0, 0, 0}, {1, 2, 3}, {0, 0, 20}}), std::nullopt);
  EXPECT_NEAR(circleFromAbove(EllipsoidMirror{{0, 0, 0}, {2, 2, 3}, {0, 0, 20}}).value_or(0), 2, 1e-12);
  // Leaning until its outline is as wide as it is long.
  EXPECT_NEAR(circleFromAbove(EllipsoidMirror{{0, 0, 0}, {1, 2, 3}, {0, 90, 0}}).value_or(0), 0, 1e-12);
  const double lean = degrees(std::asin(std::sqrt((4.0 - 1) / (9 - 1))));
  EXPECT_NEAR(circleFromAbove(EllipsoidMirror{{0, 0, 0}, {1, 2, 3}, {0, lean, 0}}).value_or(0), 2, 1e-9);
}

}  // namespace
}  // namespace anamorph
