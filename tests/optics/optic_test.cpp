#include "optics/optic.h"

#include <algorithm>
#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "optics/reflect.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(Reflect, KeepsLengthAndIgnoresTheNormalsSide) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    const Vector d = random.point(3);
    const Direction n = random.direction();
    EXPECT_NEAR(glm::length(reflect(d, n)), glm::length(d), 1e-14 * 6);
    EXPECT_EQ(reflect(d, n), reflect(d, -n));
    EXPECT_LT(glm::length(reflect(reflect(d, n), n) - d), 1e-14 * 6);
  }
}

// Of a path with two points: how far the first is, in lengths of the ray sent.
double firstTravelled(const OpticPath& path, const Ray& ray) {
  return glm::length(path.points[0] - ray.origin) / glm::length(ray.direction);
}

TEST(FollowRay, TravelledCountsInLengthsOfTheRaySent) {
  const Optic sphere{OpticKind::mirror, SphereMirror{Point(0), 1}};
  const OpticPath path = followRay(sphere, {{0, -3, 0}, {0, 4, 0}});
  ASSERT_EQ(path.pointCount, 1);
  EXPECT_DOUBLE_EQ(path.travelled, 0.5);
  EXPECT_EQ(path.points[0], Point(0, -1, 0));
  EXPECT_DOUBLE_EQ(path.sine, 1);
  EXPECT_EQ(path.exit.direction, Vector(0, -4, 0));
}

TEST(FollowRay, GoesThroughThePartsInTheirOrder) {
  Optic periscope = makePeriscope();
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Ray ray{Point(0, -5, 0) + random.point(0.2), Vector(0, 30, 0) + random.point(0.5)};
    const OpticPath path = followRay(periscope, ray);
    ASSERT_EQ(path.pointCount, 2);
    EXPECT_TRUE(path.bends);
    EXPECT_LT(glm::length(path.exit.direction - ray.direction), 1e-11) << "as a shift would have it";
    EXPECT_EQ(path.exit.origin, path.points[1]);
    EXPECT_LT(glm::length(path.points[0] + path.onward[0] * (path.travelled - firstTravelled(path, ray)) -
                          path.points[1]),
              1e-12);
    EXPECT_EQ(statusOf(periscope, path, 100), PathStatus::mapped);
  }
  std::swap(periscope.parts[0], periscope.parts[1]);
  EXPECT_EQ(followRay(periscope, {{0, -5, 0}, {0, 3, 0}}).pointCount, 0) << "they come in another order";
}

TEST(FollowRay, WhatStandsInTheWayIsNoWayThrough) {
  Optic periscope = makePeriscope();
  periscope.parts.push_back({OpticKind::mirror, SphereMirror{{0, 0, 2.5}, 0.5}});
  EXPECT_EQ(followRay(periscope, {{0, -5, 0}, {0, 3, 0}}).pointCount, 0);
  EXPECT_EQ(statusOf(periscope, followRay(periscope, {{0, -5, 0}, {0, 3, 0}}), 1), PathStatus::missesMirror);
}

TEST(FindProblem, AsksEveryPart) {
  Optic optic{OpticKind::mirror, PlaneMirror{}};
  optic.parts.push_back({OpticKind::mirror, SphereMirror{Point(9), 1}});
  EXPECT_EQ(findProblem(optic), std::nullopt);
  EXPECT_EQ(boxOf(optic).max, Point(10));
  EXPECT_EQ(findEyeProblem(optic, {0, -9, 0}), std::nullopt);
  EXPECT_THAT(findEyeProblem(optic, Point(10, 9, 9)).value_or(""), ::testing::HasSubstr("on the surface"));

  optic.parts.back().shape = SphereMirror{Point(9), -1};
  EXPECT_THAT(findProblem(optic).value_or(""), ::testing::StartsWith("the sphere mirror cannot be used: "));
  EXPECT_FALSE(isShown(optic));
  EXPECT_EQ(boxOf(optic).max, boxOf(Shape(PlaneMirror{})).max);
}

TEST(StatusOf, NamesWhatBecomesOfARay) {
  const Optic tube{OpticKind::mirror, CylinderMirror{{0, 0, 0}, {0, 0, 2}, 1}};
  const auto status = [&](const Point& eye, const Point& target, double depthScale = 1) {
    const OpticPath path = followRay(tube, {eye, target - eye});
    return statusOf(tube, path, depthScale * (1 - path.travelled));
  };
  EXPECT_EQ(status({0, -5, 1}, {0, 3, 1}), PathStatus::mapped);
  EXPECT_EQ(status({0, -5, 1}, {0, 3, 9}), PathStatus::missesMirror);
  EXPECT_EQ(status({0, -5, 1}, {0, -3, 1}), PathStatus::inFrontOfMirror);
  EXPECT_EQ(status({0.99999, -5, 1}, {0.99999, 5, 1}), PathStatus::grazing);
  // Over the near rim to the inner far wall and back to the inner near wall.
  EXPECT_EQ(status({0, -2, 2.5}, {0, 8, -1}), PathStatus::hitsMirrorAgain);
  EXPECT_EQ(status({0, -2, 2.5}, {0, 8, -1}, 0.01), PathStatus::mapped) << "it stops before the near wall";
}

// Compares the batch with one ray after the other; returns how many are mapped, and of these, plain.
std::array<std::size_t, 2> expectSameBits(const RandomScene& scene, Random& random, bool hasOffset) {
  PointArray targets;
  for (std::size_t i = 0; i < 100; ++i) {
    targets.push_back(i % 4 ? makeRandomOriginal(scene, random, 0.5) : random.point(30));
  }
  const double depthScale = random.uniform(0.1, 3);
  const double depthOffset = hasOffset ? random.uniform(0, 10) : 0;
  PointArray points(targets.size());
  std::array<std::int64_t, exitBlockSize> plain;
  const std::size_t plainCount =
      exitPoints(scene.optic, {scene.eye,
                               depthScale,
                               depthOffset,
                               {targets.x.data(), targets.y.data(), targets.z.data()},
                               targets.size(),
                               {points.x.data(), points.y.data(), points.z.data()},
                               plain.data()});
  EXPECT_EQ(std::count(plain.begin(), plain.begin() + 100, 1), static_cast<long>(plainCount));
  std::size_t mapped = 0;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    const OpticPath path = followRay(scene.optic, {scene.eye, targets[i] - scene.eye});
    double exitLength = depthScale * (1 - path.travelled);
    if (depthOffset > 0) exitLength += depthOffset / glm::length(targets[i] - scene.eye);
    const PathStatus status = statusOf(scene.optic, path, exitLength);
    mapped += status == PathStatus::mapped;
    if (!plain[i]) continue;
    EXPECT_EQ(status, PathStatus::mapped);
    EXPECT_EQ(points[i], path.exit.at(exitLength));
  }
  return {mapped, plainCount};
}

TEST(ExitPoints, PlainOnesAgreeWithFollowRayToTheBit) {
  for (const ShapeKind kind : allShapeKinds) {
    for (const bool hollow : {false, true}) {
      if (hollow && kind == ShapeKind::plane) continue;
      std::size_t mapped = 0, plain = 0;
      for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("kind " + std::to_string(int(kind)) + (hollow ? " hollow" : "") + " seed " +
                     std::to_string(seed));
        Random random(seed);
        const RandomScene scene = hollow ? makeHollowScene(kind, random) : makeRandomScene(kind, random);
        const auto [inScene, plainOnes] = expectSameBits(scene, random, seed % 2 == 1);
        mapped += inScene;
        plain += plainOnes;
        if (::testing::Test::HasFailure()) return;
      }
      EXPECT_GT(mapped, 300 * 15u);
      EXPECT_GT(plain, 0.99 * mapped) << "the plain case is the common one, kind " << int(kind) << hollow;
    }
  }
}

}  // namespace
}  // namespace anamorph
