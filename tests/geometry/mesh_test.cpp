#include "geometry/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "geometry/shapes.h"
#include "math/frame.h"

namespace anamorph {
namespace {

PointArray makePoints(std::initializer_list<Point> points) {
  PointArray result;
  for (const Point& p : points) result.push_back(p);
  return result;
}

Mesh makeTetrahedron() {
  return {makePoints({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}),
          {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

TEST(Mesh, BoundingBoxHoldsUnusedPositionsToo) {
  Mesh mesh = makeTetrahedron();
  mesh.positions.push_back({-2, 5, 0.5});
  const Box box = boundingBox(mesh.positions);
  EXPECT_EQ(box.min, Point(-2, 0, 0));
  EXPECT_EQ(box.max, Point(1, 5, 1));
  EXPECT_TRUE(boundingBox({}).empty());
}

TEST(Mesh, AreaVectorIsTwiceTheAreaAndPointsOutwards) {
  const Mesh mesh = makeTetrahedron();
  EXPECT_EQ(areaVector(mesh.positions, mesh.triangles[0]), Vector(0, 0, -1));
  EXPECT_EQ(areaVector(mesh.positions, mesh.triangles[2]), Vector(1, 1, 1));
}

TEST(Mesh, VolumeOfATetrahedronFarFromTheOrigin) {
  Mesh mesh = makeTetrahedron();
  EXPECT_DOUBLE_EQ(signedVolume(mesh), 1.0 / 6);
  mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return p + Vector(1e8, -1e8, 1e8); });
  EXPECT_DOUBLE_EQ(signedVolume(mesh), 1.0 / 6);
}

TEST(Mesh, VolumeChangesSignWithTheOrientation) {
  Mesh mesh = makeBox({1, 2, 3}, 2);
  EXPECT_DOUBLE_EQ(signedVolume(mesh), 6);
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  EXPECT_DOUBLE_EQ(signedVolume(mesh), -6);
}

TEST(Mesh, VolumeOfNothingIsZero) {
  EXPECT_EQ(signedVolume({}), 0);
}

TEST(Mesh, ClosedMeansEveryEdgeOnceInEachDirection) {
  const Mesh closed = makeTetrahedron();
  EXPECT_TRUE(isClosed(closed));

  Mesh open = closed;
  open.triangles.pop_back();
  EXPECT_FALSE(isClosed(open));

  Mesh flipped = closed;
  std::swap(flipped.triangles[1][0], flipped.triangles[1][1]);
  EXPECT_FALSE(isClosed(flipped));

  Mesh doubled = closed;
  doubled.triangles.insert(doubled.triangles.end(), closed.triangles.begin(), closed.triangles.end());
  EXPECT_FALSE(isClosed(doubled));

  EXPECT_FALSE(isClosed({}));
}

TEST(Mesh, WeldJoinsEqualPositionsInTheOrderOfTheirFirstAppearance) {
  const Mesh mesh{makePoints({{1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}}),
                  {{0, 3, 1}, {2, 3, 4}, {0, 2, 3}}};
  const WeldedMesh welded = weldPositions(mesh);
  EXPECT_EQ(welded.mesh.positions, makePoints({{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(welded.vertexOf, (std::vector<std::uint32_t>{0, 1, 0, 2, 1}));
  EXPECT_EQ(welded.mesh.triangles, (std::vector<Triangle>{{0, 2, 1}, {0, 2, 1}}));
  EXPECT_EQ(welded.triangleOf, (std::vector<std::uint32_t>{0, 1}));  // the third had two equal corners
}

TEST(Mesh, WeldTellsNeighbouringNumbersApart) {
  const Mesh mesh{makePoints({{1, 2, 3}, {std::nextafter(1.0, 2.0), 2, 3}, {1, 3, 2}}), {{0, 1, 2}}};
  EXPECT_EQ(weldPositions(mesh).mesh, mesh);
}

TEST(Mesh, WeldClosesABoxOfSeparateTriangles) {
  const Mesh box = makeBox({1, 2, 3}, 4);
  Mesh soup;
  for (const Triangle& t : box.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t corner : t) soup.positions.push_back(box.positions[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_FALSE(isClosed(soup));
  const Mesh welded = weldPositions(soup).mesh;
  EXPECT_TRUE(isClosed(welded));
  EXPECT_EQ(welded.positions.size(), box.positions.size());
}

TEST(Mesh, UnitizeCentresAndKeepsProportions) {
  Mesh mesh = makeBox({2, 6, 4}, 1);
  mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return p + Vector(100, -7, 3); });
  const Box box = boundingBox(unitize(mesh).positions);
  EXPECT_NEAR(glm::length(box.centre()), 0, 1e-15);
  EXPECT_NEAR(glm::length(box.size() - Vector(1.0 / 3, 1, 2.0 / 3)), 0, 1e-14);
}

TEST(Mesh, UnitizeOfTheSmallestAndTheLargestStaysFinite) {
  for (const double size : {5e-324, 1e-310, 1e-300, 1e9}) {
    const Mesh mesh{makePoints({{0, 0, 0}, {size, 0, 0}, {0, size, 0}}), {{0, 1, 2}}};
    const Mesh unit = unitize(mesh);
    for (std::size_t i = 0; i < unit.positions.size(); ++i) {
      EXPECT_TRUE(isFinite(unit.positions[i])) << size;
      EXPECT_LE(glm::length(unit.positions[i]), 2) << size;
    }
  }
}

TEST(Mesh, UnitizeOfAPointOnlyCentres) {
  const Mesh mesh{makePoints({{3, 4, 5}, {3, 4, 5}}), {}};
  EXPECT_EQ(unitize(mesh).positions, makePoints({{0, 0, 0}, {0, 0, 0}}));
  EXPECT_EQ(unitize({}), Mesh{});
}

}  // namespace
}  // namespace anamorph
