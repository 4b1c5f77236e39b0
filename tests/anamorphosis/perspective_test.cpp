// Without a mirror: points slid along view rays onto, or nearly onto, a canvas.

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "anamorphosis/match.h"
#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

// The floor, 40 x 40.
Optic floorCanvas() {
  return {OpticKind::canvas,
          PlaneMirror{{Point(-20, -20, 0), Point(20, -20, 0), Point(20, 20, 0), Point(-20, 20, 0)}}};
}

TEST(Perspective, EveryPointStaysOnItsViewRay) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const ShapeKind kind : allShapeKinds) {
      RandomScene scene = makeRandomScene(kind, random);
      scene.optic.parts.front().kind = OpticKind::canvas;
      const Point p = makeRandomOriginal(scene, random);
      const double k = random.uniform(0.01, 1);
      const MappedPoint mapped = mapPoint({scene.optic, scene.eye, k, {}}, p);
      ASSERT_EQ(mapped.status, PathStatus::mapped);
      const Direction sight = glm::normalize(p - scene.eye);
      EXPECT_LT(glm::length(glm::cross(sight, mapped.point - scene.eye)), 1e-9);
      EXPECT_GT(glm::dot(sight, mapped.point - scene.eye), 0);
    }
  }
}

TEST(Perspective, DepthScaleOneIsTheOriginalAndASmallOneLiesInTheCanvas) {
  const Point eye(1, -10, 6);
  for (const Point p : {Point(0, 0, 2), Point(1, 3, 1), Point(-2, 1, 0.5)}) {
    EXPECT_LT(glm::length(mapPoint({floorCanvas(), eye, 1, {}}, p).point - p), 1e-12);
    const MappedPoint flat = mapPoint({floorCanvas(), eye, 0.01, {}}, p);
    EXPECT_NEAR(flat.point.z, 0.01 * p.z, 1e-12) << "heights shrink by k";
    const MappedPoint behind = mapPoint({floorCanvas(), eye, 0.01, {}}, {p.x, p.y, -p.z});
    EXPECT_EQ(behind.status, PathStatus::mapped) << "the canvas may be before the original";
  }
}

TEST(Perspective, TheCanvasEndsSomewhereAndNothingGoesBehindTheEye) {
  const Point eye(0, -10, 6);
  EXPECT_EQ(mapPoint({floorCanvas(), eye, 0.1, {}}, {0, 0, 6}).status, PathStatus::missesMirror);
  EXPECT_EQ(mapPoint({floorCanvas(), eye, 0.1, {}}, {0, 15, 5}).status, PathStatus::missesMirror);
  EXPECT_EQ(mapPoint({floorCanvas(), eye, 1.5, {}}, {0, 0, 3}).status, PathStatus::mapped);
  // The canvas is twice as far as the original: with k = 3 it lands at 2 - 3 * 1 = -1, behind the eye.
  EXPECT_EQ(mapPoint({floorCanvas(), eye, 3, {}}, {0, 0, 3}).status, PathStatus::inFrontOfMirror);
}

TEST(Perspective, TheFlatSculptureLooksLikeTheOriginalFromTheEyeOnly) {
  DeformInput deform;
  Mesh box = makeBox({2, 2, 2}, 4);
  box.positions = mapPoints(box.positions, [](const Point& p) { return p + Point(0, 0, 1); });
  deform.original = std::make_shared<const Mesh>(box);
  deform.map.optic = floorCanvas();
  deform.map.eye = deform.camera.eye = {0, -12, 6};
  deform.camera.target = {0, 0, 1};
  deform.map.depthScale = 0.02;
  const auto sculpture = std::make_shared<const Sculpture>(makeSculpture(deform));
  EXPECT_LT(boundingBox(sculpture->mesh.positions).max.z, 0.05);
  MatchInput match;
  match.original = deform.original;
  match.originalBvh = std::make_shared<const Bvh>(box.positions, box.triangles);
  match.sculpture = sculpture;
  match.sculptureBvh = std::make_shared<const Bvh>(sculpture->mesh.positions, sculpture->mesh.triangles);
  match.optic = deform.map.optic;
  match.camera = deform.camera;
  match.width = match.height = 200;
  const MatchReport fromEye = computeMatch(match).report;
  EXPECT_GE(fromEye.silhouetteIou, 0.999);
  EXPECT_GE(fromEye.triangleAgreement, 0.99);
  EXPECT_LT(fromEye.p99Px, 0.1);
  EXPECT_EQ(fromEye.hiddenShare, 0);
  match.camera.eye = {5, -11, 6};
  EXPECT_LT(computeMatch(match).report.silhouetteIou, 0.7);
}

TEST(Perspective, WindingStaysOutward) {
  DeformInput deform;
  Mesh box = makeBox({2, 2, 2}, 1);
  box.positions = mapPoints(box.positions, [](const Point& p) { return p + Point(0, 0, 2); });
  deform.original = std::make_shared<const Mesh>(box);
  deform.map.optic = floorCanvas();
  deform.map.eye = deform.camera.eye = {0, -12, 6};
  deform.map.depthScale = 0.9;
  deform.tolerancePixels = 0;
  const Sculpture s = makeSculpture(deform);
  double volume = 0;
  for (const Triangle& t : s.mesh.triangles) {
    volume +=
        glm::dot(s.mesh.positions[t[0]], glm::cross(s.mesh.positions[t[1]], s.mesh.positions[t[2]])) / 6;
  }
  EXPECT_GT(volume, 0);
}

}  // namespace
}  // namespace anamorph
