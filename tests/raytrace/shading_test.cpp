#include "raytrace/shading.h"
#include "shapes.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

SceneHit hitFacing(const Direction& normal) {
  SceneHit hit;
  hit.normal = hit.faceNormal = normal;
  return hit;
}

TEST(BackgroundColor, IsAVerticalGradient) {
  const Background background{{1, 0, 0}, {0, 0, 1}};
  EXPECT_EQ(backgroundColor(background, {0, 0, 1}), Color(1, 0, 0));
  EXPECT_EQ(backgroundColor(background, {0, 0, -1}), Color(0, 0, 1));
  EXPECT_EQ(backgroundColor(background, {0.6, 0.8, 0}), Color(0.5, 0, 0.5));
}

TEST(PhongResponse, FollowsTheCosineAndTheHighlight) {
  const Material material{{0.5, 0.25, 1}, 0.3, 0.6, 0.4, 10};
  const double angle = radians(40);
  const Direction toLight(std::sin(angle), 0, std::cos(angle));
  const Color matte = 0.6 * std::cos(angle) * material.color;
  const auto seenAt = [&](double degreesFromNormal) {
    const double a = radians(degreesFromNormal);
    return phongResponse(material, hitFacing({0, 0, 1}), toLight, {-std::sin(a), 0, std::cos(a)});
  };
  EXPECT_LT(glm::length(seenAt(40) - (matte + Color(0.4))), 1e-14) << "in the mirrored direction";
  EXPECT_LT(glm::length(seenAt(70) - (matte + Color(0.4 * std::pow(std::cos(radians(30)), 10)))), 1e-14);
  EXPECT_LT(glm::length(seenAt(-70) - matte), 1e-6) << "far from the highlight";
}

TEST(PhongResponse, LightsBehindTheSurfaceGiveNothing) {
  const Material material;
  EXPECT_EQ(phongResponse(material, hitFacing({0, 0, 1}), {0, 0.6, -0.8}, {0, 0, 1}), Color(0));
  SceneHit leaning = hitFacing({0, 0, 1});
  leaning.normal = {0, 0.8, 0.6};
  EXPECT_EQ(phongResponse(material, leaning, {0, 0.99, -0.1}, {0, 0, 1}), Color(0))
      << "behind the triangle itself";
}

TEST(PhongResponse, FadesToNothingWhereTheTriangleTurnsAway) {
  const Material material{{1, 1, 1}, 0, 1, 0, 1};
  SceneHit hit = hitFacing({0, 0, 1});
  hit.normal = glm::normalize(Vector(0.3, 0, 1));
  double last = phongResponse(material, hit, {0.5, 0, std::sqrt(0.75)}, {0, 0, 1}).x;
  for (double elevation = 60; elevation > 0; elevation -= 0.25) {
    const double a = radians(elevation);
    const double now = phongResponse(material, hit, {std::cos(a), 0, std::sin(a)}, {0, 0, 1}).x;
    EXPECT_LE(now, 1);
    EXPECT_LT(last - now, 0.02) << "a hard edge at " << elevation;
    last = now;
  }
  EXPECT_LT(last, 0.02);
}

TEST(GroundMaterial, LinesAreDarkThinAndFadeWithDistance) {
  const Ground ground;
  const double plain = ground.material.color.x;
  EXPECT_LT(groundMaterial(ground, {3, 0.5, 0}, 1e-4).color.x, 0.95 * plain) << "on a line";
  EXPECT_EQ(groundMaterial(ground, {3.2, 0.5, 0}, 1e-4).color.x, plain) << "beside it";
  const double thin = groundMaterial(ground, {3, 0.5, 0}, 0.1).color.x;
  EXPECT_GT(thin, groundMaterial(ground, {3, 0.5, 0}, 1e-4).color.x);
  EXPECT_LT(thin, plain);
  EXPECT_GT(groundMaterial(ground, {3, 0.5, 0}, 1000).color.x, 0.98 * plain);
  EXPECT_EQ(groundMaterial({0, ground.material, 0}, {3, 0.5, 0}, 1e-4), ground.material) << "no lines wanted";
}

TEST(MirrorRim, IsSeenOnTheBorderAndEdgeOnOnly) {
  const PlaneMirror plane{{Point(-1, 0, 0), Point(1, 0, 0), Point(1, 0, 2), Point(-1, 0, 2)}};
  EXPECT_EQ(mirrorRim(plane, {0, 0, 1}, 0.8), 0);
  EXPECT_EQ(mirrorRim(plane, {0.95, 0, 0.5}, 0.8), 0);
  EXPECT_EQ(mirrorRim(plane, {1, 0, 0.5}, 0.8), 1);
  EXPECT_EQ(mirrorRim(plane, {0.3, 0, 2}, 0.8), 1);
  const CylinderMirror cylinder{{0, 0, 1}, {0, 0, 5}, 1};
  EXPECT_EQ(mirrorRim(cylinder, {1, 0, 3}, 0.5), 0);
  EXPECT_EQ(mirrorRim(cylinder, {1, 0, 5}, 0.5), 1);
  EXPECT_EQ(mirrorRim(cylinder, {1, 0, 1}, 0.5), 1);
  EXPECT_EQ(mirrorRim(cylinder, {1, 0, 3}, 0), 1);
  const ConeMirror cone{{0, 0, 0}, {0, 0, 4}, 2, 0};
  EXPECT_EQ(mirrorRim(cone, {2, 0, 0}, 0.5), 1);
  EXPECT_EQ(mirrorRim(cone, {1, 0, 2}, 0.5), 0);
  EXPECT_EQ(mirrorRim(cone, {0, 0, 4}, 0.5), 0) << "a point is no border";
  const SphereMirror sphere{{0, 0, 0}, 2};
  EXPECT_EQ(mirrorRim(sphere, {0, -2, 0}, 0.3), 0);
  EXPECT_EQ(mirrorRim(sphere, {0, -2, 0}, 0), 1);
}

}  // namespace
}  // namespace anamorph
