#include "anamorphosis/sculpture.h"

#include <algorithm>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

std::shared_ptr<const Mesh> placed(Mesh mesh, const Point& position, double scale = 1) {
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return position + scale * p; });
  return std::make_shared<const Mesh>(std::move(mesh));
}

DeformInput cylinderInput(std::shared_ptr<const Mesh> original) {
  DeformInput input;
  input.original = std::move(original);
  input.map.optic.shape() = CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3};
  input.map.eye = input.camera.eye = {0, -13.6, 9.8};
  input.camera.target = {0, 5.4, 0.8};
  return input;
}

// The point of the original that a vertex says it comes from.
Point sourcePoint(const Mesh& original, const VertexSource& source) {
  const Triangle& t = original.triangles[source.triangle];
  return (1 - source.u - source.v) * original.positions[t[0]] + source.u * original.positions[t[1]] +
         source.v * original.positions[t[2]];
}

void expectConsistent(const DeformInput& input, const Sculpture& s) {
  ASSERT_EQ(s.original.size(), s.mesh.positions.size());
  ASSERT_EQ(s.source.size(), s.mesh.positions.size());
  ASSERT_EQ(s.status.size(), s.mesh.positions.size());
  ASSERT_EQ(s.sourceTriangle.size(), s.mesh.triangles.size());
  const double size = boundingBox(input.original->positions).diagonal();
  for (std::size_t i = 0; i < s.mesh.positions.size(); ++i) {
    ASSERT_TRUE(isFinite(s.mesh.positions[i]));
    if (s.status[i] != PathStatus::mapped) continue;
    const MappedPoint mapped =
        mapPoint({input.map.optic, input.camera.eye, input.map.depthScale, {}}, s.original[i]);
    ASSERT_EQ(mapped.point, s.mesh.positions[i]) << "every vertex is mapped exactly, refined or not";
    ASSERT_LT(glm::length(sourcePoint(*input.original, s.source[i]) - s.original[i]), 1e-12 * size);
  }
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    // All corners lie on the triangle it claims to come from.
    const Vector normal =
        areaVector(input.original->positions, input.original->triangles[s.sourceTriangle[t]]);
    const Point origin = input.original->positions[input.original->triangles[s.sourceTriangle[t]][0]];
    for (const std::uint32_t corner : s.mesh.triangles[t]) {
      ASSERT_LT(std::abs(glm::dot(s.original[corner] - origin, normal)), 1e-12 * size * glm::length(normal));
      ASSERT_EQ(s.status[corner], PathStatus::mapped);
    }
  }
}

TEST(Sculpture, OffKeepsTheOriginalsVerticesInOrder) {
  DeformInput input = cylinderInput(placed(makeBox({6, 2, 2}, 4), {0, 5.4, 0.8}, 0.7));
  input.tolerancePixels = 0;
  const Sculpture s = makeSculpture(input);
  ASSERT_EQ(s.mesh.positions.size(), input.original->positions.size());
  EXPECT_EQ(s.original, input.original->positions);
  EXPECT_EQ(s.originalStatus[0], input.original->positions.size());
  expectConsistent(input, s);
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    const Triangle &was = input.original->triangles[t], is = s.mesh.triangles[t];
    EXPECT_EQ((Triangle{was[0], was[2], was[1]}), is) << "the mirror turns triangles around";
  }
}

TEST(Sculpture, ClosedStaysClosedAndOutward) {
  for (const double tolerance : {0.0, 0.05, 0.25, 2.0}) {
    for (const auto& original :
         {placed(makeBox({6, 2, 2}, 1), {0, 5.4, 0.8}, 0.7),
          placed(makeBox({6, 2, 2}, 5), {0, 5.4, 0.8}, 0.7),
          placed(makeTorusKnot(2, 3, 0.25, 60, 8), {0, 5.4, 1}, 1), placed(makeLetterF(2, 1), {0, 5.4, 1}, 1),
          placed(makePawn(2, 12), {0, 5.4, 1}, 1)}) {
      DeformInput input = cylinderInput(original);
      input.tolerancePixels = tolerance;
      input.map.depthScale = 0.4;
      const Sculpture s = makeSculpture(input);
      EXPECT_TRUE(isClosed(s.mesh)) << tolerance;
      EXPECT_GT(signedVolume(s.mesh), 0) << tolerance;
      expectConsistent(input, s);
    }
  }
}

TEST(Sculpture, FinerToleranceGivesMoreTriangles) {
  DeformInput input = cylinderInput(placed(makeBox({6, 2, 2}, 1), {0, 5.4, 0.8}, 0.7));
  std::size_t last = 12;
  for (const double tolerance : {4.0, 1.0, 0.25, 0.0625}) {
    input.tolerancePixels = tolerance;
    const Sculpture s = makeSculpture(input);
    EXPECT_GT(s.mesh.triangles.size(), last);
    EXPECT_FALSE(s.budgetHit);
    last = s.mesh.triangles.size();
  }
  EXPECT_LT(last, 20000u) << "and not more than needed";
}

TEST(Sculpture, PlaneMirrorNeedsNoRefinement) {
  DeformInput input;
  input.original = placed(makeBox({6, 2, 2}, 1), {0, 3.4, 1});
  input.map.optic.shape() = PlaneMirror{{Point(-8, 0, 0), Point(8, 0, 0), Point(8, 0, 8), Point(-8, 0, 8)}};
  input.map.eye = input.camera.eye = {0, -11.9, 6.5};
  input.camera.target = {0, 3.4, 1};
  EXPECT_EQ(makeSculpture(input).mesh.triangles.size(), 12u);
}

TEST(Sculpture, BudgetIsReportedWhenItIsHit) {
  DeformInput input = cylinderInput(placed(makeBox({6, 2, 2}, 1), {0, 5.4, 0.8}, 0.7));
  input.tolerancePixels = 0.01;
  input.maxTriangles = 500;
  const Sculpture s = makeSculpture(input);
  EXPECT_TRUE(s.budgetHit);
  EXPECT_GT(s.remainingErrorPixels, 0.01) << "what is left is really over the tolerance";
  EXPECT_LE(s.mesh.triangles.size(), 500u);
  EXPECT_GT(s.mesh.triangles.size(), 400u) << "it is used";
  EXPECT_TRUE(isClosed(s.mesh)) << "and no crack is left where it stopped";
}

TEST(Sculpture, UnweldedOriginalsAreWeldedForRefinement) {
  const Mesh box = makeBox({6, 2, 2}, 2);
  Mesh soup;  // every triangle with corners of its own, as in an STL file
  for (const Triangle& t : box.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t corner : t) soup.positions.push_back(box.positions[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  const DeformInput input = cylinderInput(placed(soup, {0, 5.4, 0.8}, 0.7));
  const Sculpture s = makeSculpture(input);
  EXPECT_TRUE(isClosed(s.mesh));
  expectConsistent(input, s);
}

TEST(Sculpture, OverhangingOriginalIsCutAtTheMirrorsEdge) {
  DeformInput input = cylinderInput(placed(makeBox({24, 0.5, 0.5}, 1), {0, 5.4, 0.8}));
  const Sculpture s = makeSculpture(input);
  EXPECT_EQ(s.originalStatus[std::size_t(PathStatus::missesMirror)], 8u) << "both ends stand out";
  ASSERT_FALSE(s.mesh.triangles.empty()) << "but its middle is mapped";
  expectConsistent(input, s);
  // What is left reaches to the edge of the mirror within about a pixel.
  double reach = 0;
  for (std::size_t i = 0; i < s.original.size(); ++i) {
    if (glm::length(s.original[i] - Point(s.original[i].x, 5.15, 1.05)) < 1e-9)
      reach = std::max(reach, s.original[i].x);
  }
  const Projection projection(input.camera, 512, 512);
  double edge = 0;  // the last x whose ray meets the mirror steeply enough
  for (double x = 0; x < 12; x += 0.001) {
    const MappedPoint mapped = mapPoint({input.map.optic, input.camera.eye, 1, {}}, {x, 5.15, 1.05});
    if (mapped.status == PathStatus::mapped) edge = x;
  }
  const auto a = projection.pixelOf({reach, 5.15, 1.05}), b = projection.pixelOf({edge, 5.15, 1.05});
  EXPECT_NEAR(a->x, b->x, 2);
}

TEST(Sculpture, MirrorSmallerThanATriangleIsFound) {
  DeformInput input;
  input.original = placed(makeBox({20, 0.1, 20}, 1), {0, 6, 0});
  input.map.optic.shape() = SphereMirror{{0.7, 0, 0.4}, 0.3};
  input.map.eye = input.camera.eye = {0, -12, 0};
  input.camera.target = {0, 0, 0};
  const Sculpture s = makeSculpture(input);
  EXPECT_GT(s.mesh.triangles.size(), 50u);
  expectConsistent(input, s);
}

TEST(Sculpture, EdgesThatPassUnderTheEyeAreRefinedBeforeTheCamera) {
  // A bar from behind the mirror to behind the camera: its long edges have one end that is not in the image.
  DeformInput input = cylinderInput(placed(makeBox({0.7, 30, 0.7}, 1), {0, -9.6, 0.8}));
  input.camera.target = {0, 5.4, 5};
  const Sculpture s = makeSculpture(input);
  ASSERT_FALSE(s.mesh.triangles.empty());
  double nearest = 1e9, farthest = -1e9;
  for (std::size_t i = 0; i < s.original.size(); ++i) {
    nearest = std::min(nearest, s.original[i].y);
    farthest = std::max(farthest, s.original[i].y);
  }
  EXPECT_NEAR(farthest, 5.4, 1e-9);
  EXPECT_LT(nearest, -2.5) << "up to the mirror's front, where the bar goes through it";
  expectConsistent(input, s);
}

TEST(Sculpture, NothingMappedIsEmptyNotWrong) {
  DeformInput input = cylinderInput(placed(makeBox({1, 1, 1}, 2), {40, 5, 1}));
  for (const double tolerance : {0.0, 0.25}) {
    input.tolerancePixels = tolerance;
    const Sculpture s = makeSculpture(input);
    EXPECT_TRUE(s.mesh.triangles.empty());
    EXPECT_EQ(s.originalStatus[0], 0u);
    EXPECT_EQ(s.originalStatus[std::size_t(PathStatus::missesMirror)], input.original->positions.size());
  }
}

TEST(Sculpture, SameForEveryThreadCount) {
  const DeformInput input = cylinderInput(placed(makeTorusKnot(2, 3, 0.25, 40, 6), {0, 5.4, 1}, 1));
  const Sculpture one = makeSculpture(input, 1), four = makeSculpture(input, 4);
  EXPECT_EQ(one.mesh, four.mesh);
  EXPECT_EQ(one.original, four.original);
  EXPECT_EQ(one.sourceTriangle, four.sourceTriangle);
}

TEST(Sculpture, CancelledIsEmpty) {
  const DeformInput input = cylinderInput(placed(makeBox({6, 2, 2}, 1), {0, 5.4, 0.8}, 0.7));
  Progress progress;
  progress.token.cancel();
  EXPECT_TRUE(makeSculpture(input, 1, progress).mesh.triangles.empty());
}

TEST(RemapSculpture, FollowsTheEyeWithTheSameTriangles) {
  DeformInput input = cylinderInput(placed(makeBox({6, 2, 2}, 4), {0, 5.4, 0.8}, 0.7));
  Sculpture s = makeSculpture(input);
  const std::vector<Triangle> triangles = s.mesh.triangles;
  input.map.eye = input.camera.eye = {1, -14, 11};
  input.map.depthScale = 0.5;
  remapSculpture(input.map, s, 2);
  EXPECT_EQ(s.mesh.triangles, triangles);
  expectConsistent(input, s);
}

// Random scenes: the refined sculpture of a random box is closed when all of it is mapped, exact and finite
// always.
TEST(Sculpture, RandomScenes) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 100; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      DeformInput input;
      input.map.optic = scene.optic;
      input.map.eye = input.camera.eye = scene.eye;
      input.camera.target = scene.onMirror;
      input.imageSize = 128;
      input.maxTriangles = 20000;
      const Point centre = makeRandomOriginal(scene, random, 0.3);
      input.original = placed(
          makeBox(Vector(random.uniform(0.1, 3), random.uniform(0.1, 3), random.uniform(0.1, 3)), 2), centre);
      const Sculpture s = makeSculpture(input);
      expectConsistent(input, s);
      const bool whole = s.originalStatus[0] == input.original->positions.size();
      if (whole && !s.mesh.triangles.empty() && scene.optic.shape().as<PlaneMirror>()) {
        EXPECT_TRUE(isClosed(s.mesh));
      }
    }
  }
}

// Fact G9.
TEST(Sculpture, OutwardStaysOutwardOnEveryConvexMirror) {
  for (const ShapeKind kind : allShapeKinds) {
    std::size_t whole = 0;
    for (unsigned seed = 0; seed < 1000; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      DeformInput input;
      input.map.optic = scene.optic;
      input.map.eye = input.camera.eye = scene.eye;
      input.map.depthScale = random.uniform(0.1, 2);
      input.camera.target = scene.onMirror;
      input.tolerancePixels = 0;
      input.original =
          placed(makeBox(Vector(random.uniform(0.05, 0.3)), 3), makeRandomOriginal(scene, random));
      const Sculpture s = makeSculpture(input);
      if (s.originalStatus[0] != input.original->positions.size()) continue;
      if (s.folded.triangles > 0) continue;  // partly on the inner wall, through an open end
      ++whole;
      EXPECT_TRUE(isClosed(s.mesh));
      EXPECT_GT(signedVolume(s.mesh), 0);
    }
    EXPECT_GT(whole, 500u);
  }
}

}  // namespace
}  // namespace anamorph
