// The three published mistakes, each by itself against the formula in the method's table (section 3).

#include <cmath>
#include <variant>

#include <gtest/gtest.h>

#include "anamorphosis/map_points.h"
#include "anamorphosis/sculpture.h"
#include "anamorphosis/vertex_ray.h"
#include "geometry/shapes.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

const Optic column{OpticKind::mirror, CylinderMirror{{0, 0, 0}, {0, 0, 10}, 3}};
const Point eye{0, -9.1, 9.6};
const Point vertex{1.2, 3.9, 2.3};

TEST(Mistakes, NoneIsTheRightMapToTheBit) {
  const MappedPoint right = mapPoint({column, eye, 0.4, 0, {}}, vertex);
  const MappedPoint none = mapPoint({column, eye, 0.4, 0, Mistakes{}}, vertex);
  EXPECT_EQ(right.point, none.point);
  EXPECT_FALSE(Mistakes{}.any());
}

TEST(Mistakes, TheDirectionIsTurnedAround) {
  const VertexRay right = makeVertexRay({column, eye, 0.4, 0, {}}, vertex);
  const VertexRay wrong = makeVertexRay({column, eye, 0.4, 0, {.direction = true}}, vertex);
  EXPECT_LT(glm::length(wrong.legs.back().direction + right.legs.back().direction), 1e-12);
  EXPECT_LT(glm::length(wrong.sculpture - (2.0 * right.legs.back().start - right.sculpture)), 1e-12);
  const double fromAxis = std::hypot(wrong.sculpture.x, wrong.sculpture.y);
  EXPECT_LT(fromAxis, 3) << "it lands inside the column";
}

TEST(Mistakes, TheDistanceTakesAPointFromADirection) {
  const VertexRay right = makeVertexRay({column, eye, 1, 0, {}}, vertex);
  const VertexRay wrong = makeVertexRay({column, eye, 1, 0, {.distance = true}}, vertex);
  const double published = glm::length((vertex - eye) - right.legs.back().start);
  EXPECT_NEAR(wrong.distance, published, 1e-12);
  EXPECT_NEAR(glm::length(wrong.sculpture - right.legs.back().start), published, 1e-12);
  EXPECT_GT(wrong.distance / right.distance, 1.5) << "1.5 to 7.3 times too far";
  EXPECT_EQ(wrong.legs.back().direction, right.legs.back().direction);
}

TEST(Mistakes, TheNormalComesFromTheMiddleAsOfASphere) {
  const VertexRay right = makeVertexRay({column, eye, 0.4, 0, {}}, vertex);
  const VertexRay wrong = makeVertexRay({column, eye, 0.4, 0, {.normal = true}}, vertex);
  EXPECT_LT(glm::length(wrong.legs.back().normal - glm::normalize(right.legs.back().start - Point(0, 0, 5))),
            1e-12);
  EXPECT_GT(degrees(std::acos(glm::dot(wrong.legs.back().normal, right.legs.back().normal))), 1);
  EXPECT_NEAR(glm::dot(wrong.legs.back().direction, wrong.legs.back().normal),
              -glm::dot(glm::normalize(vertex - eye), wrong.legs.back().normal), 1e-12);
}

TEST(Mistakes, TheNormalIsRightOnPlaneAndSphere) {
  for (const Shape& shape : {Shape(PlaneMirror{}), Shape(SphereMirror{{0, 0, 0}, 1})}) {
    const Optic optic{OpticKind::mirror, shape};
    const Point p{0.1, 2, 0.2}, e{0.2, -4, 0.7};
    EXPECT_EQ(mapPoint({optic, e, 1, 0, {.normal = true}}, p).status, PathStatus::mapped);
    EXPECT_LT(glm::length(mapPoint({optic, e, 1, 0, {.normal = true}}, p).point -
                          mapPoint({optic, e, 1, 0, {}}, p).point),
              1e-12);
  }
}

TEST(Mistakes, OfAllVerticesAsOfOne) {
  const Mesh box = makeBox({3, 2, 1}, 4);
  const PointArray placed = mapPoints(box.positions, [](const Point& p) { return p + Point(0, 4, 2); });
  for (int bits = 0; bits < 8; ++bits) {
    const Mistakes mistakes{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0};
    MappedPoints mapped;
    mapPointsThrough({column, eye, 0.3, 0, mistakes}, placed, mapped, 2);
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const MappedPoint one = mapPoint({column, eye, 0.3, 0, mistakes}, placed[i]);
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
        const VertexRay ray = makeVertexRay({scene.optic, scene.eye, 1, 0, mistakes}, p);
        EXPECT_TRUE(isFinite(ray.sculpture) && std::isfinite(ray.distance));
        for (const VertexLeg& leg : ray.legs)
          EXPECT_TRUE(std::isfinite(leg.angleInDegrees) && std::isfinite(leg.angleOutDegrees));
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
  input.map.optic = column;
  input.map.eye = input.camera.eye = eye;
  input.map.mistakes.direction = true;
  const Sculpture sculpture = makeSculpture(input);
  EXPECT_EQ(sculpture.mesh.positions.size(), moved.positions.size());
}

}  // namespace
}  // namespace anamorph
