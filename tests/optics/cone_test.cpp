#include "optics/cone.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optics/optic.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(Cone, WithEqualRadiiIsTheCylinderToTheBit) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomScene scene = makeRandomScene(ShapeKind::cylinder, random);
    const auto& tube = shapeAs<CylinderMirror>(scene.optic.shape());
    const ConeMirror cone{tube.bottom, tube.top, tube.radius, tube.radius};
    const Ray ray{scene.eye, scene.onMirror + random.point(1) - scene.eye};
    const auto a = intersect(tube, ray), b = intersect(cone, ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    EXPECT_EQ(a->t, b->t);
    EXPECT_LT(glm::length(a->normal - b->normal), 1e-14);
  }
}

TEST(Cone, WithNearlyEqualRadiiLosesNoDigits) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomScene scene = makeRandomScene(ShapeKind::cylinder, random);
    const auto& tube = shapeAs<CylinderMirror>(scene.optic.shape());
    const ConeMirror cone{tube.bottom, tube.top, tube.radius, tube.radius * (1 + 1e-13)};
    const Ray ray{scene.eye, scene.onMirror - scene.eye};
    const auto hit = intersect(cone, ray);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 1, 1e-11);
  }
}

TEST(Cone, IsNotItsOtherNappe) {
  const ConeMirror cone{{0, 0, 0}, {0, 0, 4}, 2, 0};
  EXPECT_FALSE(intersect(cone, {{0, -9, 6}, {0, 1, 0}}));
  // Down through where the other nappe would be, on to the cone.
  const auto hit = intersect(cone, {{0, 0.5, 8}, {0, 0, -1}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.z, 3, 1e-12);
  EXPECT_GT(hit->normal.z, 0);
  EXPECT_EQ(findEyeProblem(cone, {0, 0, 8}), std::nullopt) << "over the point, on the axis";
}

TEST(Cone, IsMetOnceByARayAlongARuling) {
  const ConeMirror cone{{0, 0, 0}, {0, 0, 4}, 2, 0};
  const Vector ruling(0, 1, 2);  // of the side at y < 0, moved: it meets the opposite side
  const auto hit = intersect(cone, {Point(0, -4, -4) + Vector(0, 1.5, 0), ruling});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(std::hypot(hit->point.x, hit->point.y), 2 - hit->point.z / 2, 1e-12);
}

// Fact G4: what a reflection keeps is the part along the ruling through Q.
TEST(Cone, KeepsThePartAlongTheRuling) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const RandomScene scene = makeRandomScene(ShapeKind::cone, random);
    const auto& cone = shapeAs<ConeMirror>(scene.optic.shape());
    const Point p = makeRandomOriginal(scene, random);
    const OpticPath path = followRay(scene.optic, {scene.eye, p - scene.eye});
    ASSERT_EQ(path.pointCount, 1);
    const Point q = path.points[0], s = path.exit.at(1 - path.travelled);
    const Vector w = q - cone.bottom;
    const Direction out = glm::normalize(w - glm::dot(w, cone.axis()) * cone.axis());
    const Direction ruling =
        glm::normalize(cone.top + cone.topRadius * out - cone.bottom - cone.bottomRadius * out);
    EXPECT_NEAR(glm::dot(s - q, ruling), glm::dot(p - q, ruling), 1e-11);
  }
}

TEST(Cone, SeenFromItsAxisKeepsTheAzimuth) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const ConeMirror cone{{0, 0, 0}, {0, 0, 3}, random.uniform(2, 5), 0};
    const Optic optic{OpticKind::mirror, cone};
    const Point eye(0, 0, random.uniform(8, 20));
    const double azimuth = random.uniform(0, 2 * pi), out = random.uniform(0.1, 0.9) * cone.bottomRadius;
    const Direction along(std::cos(azimuth), std::sin(azimuth), 0), across(-along.y, along.x, 0);
    const OpticPath path = followRay(optic, {eye, out * along - eye});
    ASSERT_EQ(path.pointCount, 1);
    EXPECT_NEAR(glm::dot(path.exit.direction, across), 0, 1e-12);
    EXPECT_GT(glm::dot(path.exit.direction, along), 0);
  }
}

TEST(Cone, CarriedOnEndsAtItsApex) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Shape shape = makeRandomScene(ShapeKind::cone, random).optic.shape();
    const ConeMirror grown = shapeAs<ConeMirror>(continued(shape));
    EXPECT_EQ(findShapeProblem(grown), std::nullopt);
    EXPECT_NEAR(std::min(grown.bottomRadius, grown.topRadius), 0, 1e-9 * grown.widest());
    EXPECT_GT(grown.height(), 900 * shapeAs<ConeMirror>(shape).height());
  }
}

}  // namespace
}  // namespace anamorph
