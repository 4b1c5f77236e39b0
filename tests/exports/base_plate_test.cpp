#include "exports/base_plate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "error_text.h"
#include "exports/arrangement.h"
#include "exports/print_check.h"
#include "finished.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

using ::testing::HasSubstr;

Mesh moved(Mesh mesh, const Vector& v) {
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return p + v; });
  return mesh;
}

const Mesh farMirror = moved(makeBox({1, 1, 1}, 1), {500, 0, 0});

TEST(BasePlate, CarriesAFloatingSculptureOnPostsThatReachIntoIt) {
  const Mesh ball = moved(makeSphere(20, 32), {5, 7, 60});
  const BasePlate plate = makeBasePlate(ball, farMirror, 0, {.thickness = 3, .margin = 4});
  EXPECT_EQ(plate.lowerFace, 0);
  EXPECT_GE(plate.posts.size(), 3u);
  const Box box = boundingBox(plate.mesh.positions);
  EXPECT_EQ(box.min.z, 0);
  EXPECT_GT(box.max.z, 40) << "into the ball, which begins at 40";
  EXPECT_LT(box.max.z, 61);
  EXPECT_NEAR(box.max.x - box.min.x, 2 * (20 + 4), 0.5);
  // The plate and every post are closed shells of their own.
  const PrintCheck check = *checkPrint(plate.mesh);
  EXPECT_TRUE(check.topology.isSound());
  EXPECT_EQ(check.parts, 1 + plate.posts.size());
  EXPECT_EQ(check.insideOut, 0u);
  // Each post's top is in the ball: just below its surface.
  for (std::size_t i = 0; i < plate.mesh.positions.size(); ++i) {
    const Point p = plate.mesh.positions[i];
    if (p.z <= 3) continue;
    const double deep = 20 - glm::length(p - Point(5, 7, 60));
    EXPECT_GT(deep, -0.2);
    EXPECT_LT(deep, 0.6);
  }
}

TEST(BasePlate, IsLetInBelowASculptureThatStandsOnTheTable) {
  const Mesh box = moved(makeBox({40, 20, 20}, 2), {0, 0, 10});
  const BasePlate plate = makeBasePlate(box, farMirror, 0, {.thickness = 2, .margin = 3});
  EXPECT_TRUE(plate.posts.empty());
  EXPECT_DOUBLE_EQ(plate.lowerFace, -1.8) << "a layer into the sculpture";
  EXPECT_DOUBLE_EQ(boundingBox(plate.mesh.positions).max.z, 0.2);
}

TEST(BasePlate, IsRefusedWhereTheMirrorStands) {
  const LevelResult& sphere = testing::finishedLevel("3-sphere");
  EXPECT_THAT(errorOf([&] { makeArrangement(sphere, 10, BasePlateSettings{}); }),
              HasSubstr("no base plate can bear this sculpture"));
}

TEST(BasePlate, OfTheCylinderLevelHidesNothing) {
  const LevelResult& cylinder = testing::finishedLevel("2-cylinder");
  const Arrangement arrangement = makeArrangement(cylinder, 10, BasePlateSettings{});
  ASSERT_TRUE(arrangement.plate);
  EXPECT_EQ(arrangement.plate->lowerFace, arrangement.table);
  EXPECT_EQ(fractionHiddenByPlate(cylinder, arrangement), 0);
  // A plate as large as a wall does hide the mirror.
  Arrangement walled = arrangement;
  walled.plate->mesh = moved(makeBox({200, 1, 400}, 1), {0, -60, 0});
  EXPECT_GT(fractionHiddenByPlate(cylinder, walled), 0.9);
}

TEST(ConvexHull, HasTheCornersOnly) {
  const auto hull = convexHull({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}});
  EXPECT_EQ(hull, (std::vector<glm::dvec2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}}));
}

}  // namespace
}  // namespace anamorph
