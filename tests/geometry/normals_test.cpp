#include "geometry/normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>

#include "geometry/shapes.h"

namespace anamorph {
namespace {

std::vector<glm::vec3> normalsOf(const Mesh& mesh, const NormalGroups& groups, int threads = 1) {
  return computeNormals(mesh.positions, mesh.triangles, groups, threads);
}

/// Two squares that meet along the y axis, the second turned by `degrees` out of the first one's plane.
Mesh makeHinge(double degrees) {
  const double c = std::cos(radians(degrees)), s = std::sin(radians(degrees));
  Mesh mesh;
  for (const Point& p :
       {Point(0, 0, 0), Point(0, 1, 0), Point(-1, 0, 0), Point(-1, 1, 0), Point(c, 0, s), Point(c, 1, s)}) {
    mesh.positions.push_back(p);
  }
  mesh.triangles = {{2, 0, 1}, {2, 1, 3}, {0, 4, 5}, {0, 5, 1}};
  return mesh;
}

TEST(Normals, CubeHasFourCornersOnEachOfSixFaces) {
  const Mesh cube = makeBox({1, 2, 3}, 1);
  const NormalGroups groups = makeNormalGroups(cube);
  EXPECT_EQ(groups.count, 24u);
  const std::vector<glm::vec3> normals = normalsOf(cube, groups);
  for (std::size_t i = 0; i < cube.triangles.size(); ++i) {
    const glm::vec3 expected = glm::normalize(areaVector(cube.positions, cube.triangles[i]));
    for (const std::uint32_t corner : groups.corners[i]) EXPECT_EQ(normals[corner], expected);
  }
}

TEST(Normals, CubeIsSmoothAtACreaseOfItsOwnAngle) {
  EXPECT_EQ(makeNormalGroups(makeBox({1, 2, 3}, 1), 90).count, 8u);
  EXPECT_EQ(makeNormalGroups(makeBox({1, 2, 3}, 1), 89).count, 24u);
}

TEST(Normals, FineSphereHasOnePerVertexPointingOutwards) {
  const Mesh sphere = makeSphere(2, 64);
  const NormalGroups groups = makeNormalGroups(sphere);
  EXPECT_EQ(groups.count, sphere.positions.size());
  const std::vector<glm::vec3> normals = normalsOf(sphere, groups);
  for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
    for (int corner = 0; corner < 3; ++corner) {
      const Vector normal = normals[groups.corners[i][corner]];
      EXPECT_NEAR(glm::length(normal), 1, 1e-6);
      EXPECT_GT(glm::dot(normal, glm::normalize(sphere.positions[sphere.triangles[i][corner]])), 0.999);
    }
  }
}

TEST(Normals, CreaseAngleDecidesBetweenSharpAndSmooth) {
  const struct {
    double degrees, crease;
    std::size_t count;
  } table[] = {{20, 30, 6},  {29.9, 30, 6}, {30, 30, 6}, {30.1, 30, 8}, {90, 30, 8},  {90, 90, 6},
               {-20, 30, 6}, {-60, 30, 8},  {20, 0, 8},  {0, 0, 6},     {179, 180, 6}};
  for (const auto& row : table) {
    EXPECT_EQ(makeNormalGroups(makeHinge(row.degrees), row.crease).count, row.count)
        << row.degrees << " at crease " << row.crease;
  }
}

TEST(Normals, SmoothEdgesOfACornerJoinOnlyThroughEachOther) {
  // Around the tip of a cone everything is smooth but one sharp edge: still one group, joined the other way
  // round.
  Mesh fan;
  fan.positions.push_back({0, 0, 0});
  const double heights[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  for (int i = 0; i < 8; ++i)
    fan.positions.push_back({std::cos(pi * i / 4), std::sin(pi * i / 4), heights[i]});
  for (std::uint32_t i = 0; i < 8; ++i) fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % 8});
  const NormalGroups groups = makeNormalGroups(fan, 30);
  std::set<std::uint32_t> atTip;
  for (const Triangle& t : groups.corners) atTip.insert(t[0]);
  EXPECT_EQ(atTip.size(), 1u);
}

TEST(Normals, EdgesOfThreeFacesAreSharp) {
  Mesh mesh = makeHinge(10);
  EXPECT_EQ(makeNormalGroups(mesh).count, 6u);
  mesh.positions.push_back({0, 0.5, 1});
  mesh.triangles.push_back({0, 1, 6});
  EXPECT_EQ(makeNormalGroups(mesh).count, 11u);
}

TEST(Normals, FacesOfOppositeWindingShareNothing) {
  for (const double degrees : {0.0, 90.0, 179.0}) {
    Mesh mesh = makeHinge(degrees);
    std::swap(mesh.triangles[2][1], mesh.triangles[2][2]);
    std::swap(mesh.triangles[3][1], mesh.triangles[3][2]);
    EXPECT_EQ(makeNormalGroups(mesh, 120).count, 8u) << degrees;
  }
}

TEST(Normals, FacesWithoutAreaStandAloneAndPointUp) {
  Mesh mesh = makeHinge(0);
  mesh.positions.push_back({1, 0.5, 0});
  mesh.triangles.push_back({5, 4, 6});
  mesh.triangles.push_back({3, 3, 3});
  mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return Point(p.z, p.x, p.y); });
  for (const double crease : {30.0, 180.0}) {
    const NormalGroups groups = makeNormalGroups(mesh, crease);
    const std::vector<glm::vec3> normals = normalsOf(mesh, groups);
    for (std::size_t face = 0; face < 6; ++face) {
      const glm::vec3 expected = face < 4 ? glm::vec3(1, 0, 0) : glm::vec3(0, 0, 1);
      for (const std::uint32_t corner : groups.corners[face]) EXPECT_EQ(normals[corner], expected);
    }
  }
}

TEST(Normals, FollowMovedPointsWithTheSameGroups) {
  Mesh mesh = makeSphere(1, 32);
  const NormalGroups groups = makeNormalGroups(mesh);
  const std::vector<glm::vec3> before = normalsOf(mesh, groups);
  // Turned by a quarter about z.
  mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return Point(-p.y, p.x, p.z); });
  const std::vector<glm::vec3> after = normalsOf(mesh, groups);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i].x, -before[i].y, 1e-6);
    EXPECT_NEAR(after[i].y, before[i].x, 1e-6);
    EXPECT_NEAR(after[i].z, before[i].z, 1e-6);
  }
}

TEST(Normals, TinyAndHugeMeshesToo) {
  for (const double scale : {1e-100, 1e-6, 1e6, 1e100}) {
    Mesh mesh = makeSphere(1, 32);
    mesh.positions = mapPoints(mesh.positions, [scale](const Point& p) { return scale * p; });
    const NormalGroups groups = makeNormalGroups(mesh);
    EXPECT_EQ(groups.count, mesh.positions.size()) << scale;
    for (const glm::vec3& normal : normalsOf(mesh, groups))
      EXPECT_NEAR(glm::length(normal), 1, 1e-6) << scale;
  }
}

TEST(Normals, AreTheSameForEveryThreadCount) {
  const Mesh mesh = makeTorusKnot(2, 3, 0.3, 500, 50);
  const NormalGroups groups = makeNormalGroups(mesh);
  EXPECT_EQ(normalsOf(mesh, groups, 1), normalsOf(mesh, groups, 4));
}

TEST(Normals, OfNothingAreNone) {
  const NormalGroups groups = makeNormalGroups(Mesh());
  EXPECT_EQ(groups.count, 0u);
  EXPECT_TRUE(normalsOf(Mesh(), groups).empty());
}

}  // namespace
}  // namespace anamorph
