// The three published mistakes, each by itself against the formula in the method's table (section 3).

#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include "anamorphosis/map_points.h"
#include "anamorphosis/sculpture.h"
#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

const Optic column{OpticKind::mirror, CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3}};
const Point eye{0, -9.1, 9.6};
const Point vertex{1.2, 3.9, 2.3};

TEST(Mistakes, NoneIsTheRightMapToTheBit) {
  const MappedPoint right = mapPoint(column, eye, vertex, 0.4);
  const MappedPoint none = mapPoint(column, eye, vertex, 0.4, Mistakes{});
  EXPECT_EQ(right.point, none.point);
  EXPECT_FALSE(Mistakes{}.any());
}

TEST(Mistakes, TheDirectionIsTurnedAround) {
  const VertexRay right = makeVertexRay(column, eye, vertex, 0.4);
  const VertexRay wrong = makeVertexRay(column, eye, vertex, 0.4, {.direction = true});
  EXPECT_LT(glm::length(wrong.reflected + right.reflected), 1e-12);
  EXPECT_LT(glm::length(wrong.sculpture - (2.0 * right.mirror - right.sculpture)), 1e-12);
  const double fromAxis = std::hypot(wrong.sculpture.x, wrong.sculpture.y);
  EXPECT_LT(fromAxis, 3) << "it lands inside the column";
}

TEST(Mistakes, TheDistanceTakesAPointFromADirection) {
  const VertexRay right = makeVertexRay(column, eye, vertex, 1);
  const VertexRay wrong = makeVertexRay(column, eye, vertex, 1, {.distance = true});
  const double published = glm::length((vertex - eye) - right.mirror);
  EXPECT_NEAR(wrong.distance, published, 1e-12);
  EXPECT_NEAR(glm::length(wrong.sculpture - right.mirror), published, 1e-12);
  EXPECT_GT(wrong.distance / right.distance, 1.5) << "1.5 to 7.3 times too far";
  EXPECT_EQ(wrong.reflected, right.reflected);
}

TEST(Mistakes, TheNormalComesFromTheMiddleAsOfASphere) {
  const VertexRay right = makeVertexRay(column, eye, vertex, 0.4);
  const VertexRay wrong = makeVertexRay(column, eye, vertex, 0.4, {.normal = true});
  EXPECT_LT(glm::length(wrong.normal - glm::normalize(right.mirror - Point(0, 0, 5))), 1e-12);
  EXPECT_GT(degrees(std::acos(glm::dot(wrong.normal, right.normal))), 1);
  EXPECT_NEAR(glm::dot(wrong.reflected, wrong.normal), -glm::dot(glm::normalize(vertex - eye), wrong.normal),
              1e-12);
}

TEST(Mistakes, TheNormalIsRightOnPlaneAndSphere) {
  for (const Shape& shape : {Shape(PlaneMirror{}), Shape(SphereMirror{{0, 0, 0}, 1})}) {
    const Optic optic{OpticKind::mirror, shape};
    const Point p{0.1, 2, 0.2}, e{0.2, -4, 0.7};
    EXPECT_EQ(mapPoint(optic, e, p, 1, {.normal = true}).status, PathStatus::mapped);
    EXPECT_LT(glm::length(mapPoint(optic, e, p, 1, {.normal = true}).point - mapPoint(optic, e, p, 1).point),
              1e-12);
  }
}

TEST(Mistakes, OfAllVerticesAsOfOne) {
  const Mesh box = makeBox({3, 2, 1}, 4);
  const PointArray placed = mapPoints(box.positions, [](const Point& p) { return p + Point(0, 4, 2); });
  for (int bits = 0; bits < 8; ++bits) {
    const Mistakes mistakes{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
    MappedPoints mapped;
    mapPointsThrough(column, eye, placed, 0.3, mapped, 2, mistakes);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const MappedPoint one = mapPoint(column, eye, placed[i], 0.3, mistakes);
      ASSERT_EQ(mapped.points[i], one.point) << bits << " " << i;
      ASSERT_EQ(mapped.status[i], one.status) << bits << " " << i;
      ASSERT_TRUE(isFinite(mapped.points[i]));
    }
  }
}

TEST(Mistakes, NeverNaN) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    for (const ShapeKind kind : allShapeKinds) {
      const RandomScene scene = makeRandomScene(kind, random);
      const Point p = makeRandomOriginal(scene, random, 2);
      for (int bits = 1; bits < 8; ++bits) {
        const Mistakes mistakes{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
        const VertexRay ray = makeVertexRay(scene.optic, scene.eye, p, 1, mistakes);
        EXPECT_TRUE(isFinite(ray.sculpture) && std::isfinite(ray.distance) &&
                    std::isfinite(ray.angleDegrees));
      }
    }
  }
}

TEST(Mistakes, AreMadeWithTheOriginalsOwnVertices) {
  DeformInput input;
  input.original = std::make_shared<const Mesh>(makeBox({2, 2, 2}, 1));
  Mesh moved = *input.original;
  moved.positions = mapPoints(moved.positions, [](const Point& p) { return p + Point(0, 4, 2); });
  input.original = std::make_shared<const Mesh>(moved);
  input.optic = column;
  input.camera.eye = eye;
  input.mistakes.direction = true;
  const Sculpture sculpture = makeSculpture(input);
  EXPECT_EQ(sculpture.mesh.positions.size(), moved.positions.size());
}

}  // namespace
}  // namespace anamorph
