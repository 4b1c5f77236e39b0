#include "geometry/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/check.h"
#include "geometry/block_shape.h"

namespace anamorph {
namespace {

using PointSet = std::set<std::array<double, 3>>;

PointSet pointSet(const PointArray& points) {
  PointSet set;
  for (std::size_t i = 0; i < points.size(); ++i) set.insert({points[i].x, points[i].y, points[i].z});
  return set;
}

std::map<std::string, Mesh> allShapes() {
  std::map<std::string, Mesh> shapes;
  for (const int segments : {1, 2, 5, 32}) {
    shapes["box " + std::to_string(segments)] = makeBox({6, 2, 2}, segments);
    shapes["F " + std::to_string(segments)] = makeLetterF(2, segments);
  }
  for (const int segments : {3, 4, 7, 64}) {
    shapes["sphere " + std::to_string(segments)] = makeSphere(1.5, segments);
    shapes["pawn " + std::to_string(segments)] = makePawn(2, segments);
  }
  shapes["trefoil"] = makeTorusKnot(2, 3, 0.2, 128, 16);
  shapes["knot 3 5"] = makeTorusKnot(3, 5, 0.1, 300, 3);
  shapes["ring"] = makeTorusKnot(1, 0, 0.2, 3, 3);
  return shapes;
}

TEST(Shapes, AllAreClosedOutwardAndWeldedWithoutUnusedVertices) {
  for (const auto& [name, mesh] : allShapes()) {
    EXPECT_TRUE(isClosed(mesh)) << name;
    EXPECT_GT(signedVolume(mesh), 0) << name;
    EXPECT_EQ(pointSet(mesh.positions).size(), mesh.positions.size()) << name;
    std::set<std::uint32_t> used;
    for (const Triangle& t : mesh.triangles) {
      used.insert(t.begin(), t.end());
      EXPECT_GT(glm::length(areaVector(mesh.positions, t)), 0) << name;
    }
    EXPECT_EQ(used.size(), mesh.positions.size()) << name;
    const Box box = boundingBox(mesh.positions);
    EXPECT_NEAR(box.centre().z, 0, 1e-12) << name;
  }
}

// V - E + F, with three half-edges a triangle.
std::int64_t eulerCharacteristic(const Mesh& mesh) {
  return static_cast<std::int64_t>(mesh.positions.size()) -
         static_cast<std::int64_t>(mesh.triangles.size()) / 2;
}

TEST(Shapes, HaveTheTopologyOfABallOrOfARing) {
  for (const auto& [name, mesh] : allShapes()) {
    const bool isRing = name == "trefoil" || name == "knot 3 5" || name == "ring";
    EXPECT_EQ(eulerCharacteristic(mesh), isRing ? 0 : 2) << name;
  }
}

TEST(Shapes, TheThesisBoxHasItsVerticesExactly) {
  const Mesh box = makeBox({6, 2, 2}, 32);
  EXPECT_EQ(box.positions.size(), 6146u);
  EXPECT_EQ(box.triangles.size(), 12288u);
  PointSet expected;
  for (int i = 0; i <= 32; ++i) {
    for (int j = 0; j <= 32; ++j) {
      for (int k = 0; k <= 32; ++k) {
        if (i % 32 == 0 || j % 32 == 0 || k % 32 == 0)
          expected.insert({-3 + i * 0.1875, -1 + j * 0.0625, -1 + k * 0.0625});
      }
    }
  }
  EXPECT_EQ(pointSet(box.positions), expected);
}

TEST(Shapes, TheCubeHasEightVertices) {
  const Mesh cube = makeBox({2, 2, 2}, 1);
  PointSet corners;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) corners.insert({x, y, z});
    }
  }
  EXPECT_EQ(pointSet(cube.positions), corners);
  EXPECT_EQ(cube.triangles.size(), 12u);
  EXPECT_DOUBLE_EQ(signedVolume(cube), 8);
}

TEST(Shapes, ABoxIsExactlySymmetric) {
  const PointSet points = pointSet(makeBox({0.7, 1.1, 1.3}, 7).positions);
  for (const auto& [x, y, z] : points)
    EXPECT_TRUE(points.contains({-x, -y, -z})) << x << " " << y << " " << z;
}

TEST(Shapes, SphereVerticesLieOnTheSphere) {
  const Mesh sphere = makeSphere(2.5, 64);
  EXPECT_EQ(sphere.positions.size(), 64u * 31 + 2);
  for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(sphere.positions[i]), 2.5, 1e-15 * 4);
  }
  EXPECT_NEAR(signedVolume(sphere), 4.0 / 3 * pi * std::pow(2.5, 3), 0.5);
}

TEST(Shapes, KnotFitsItsBoxAndHasNoSeam) {
  const int segments = 200, sides = 12;
  const Mesh knot = makeTorusKnot(2, 3, 0.2, segments, sides);
  const Vector size = boundingBox(knot.positions).size();
  EXPECT_NEAR(std::max({size.x, size.y, size.z}), 2, 1e-12);
  // Steps from ring to ring change smoothly; a twist or a seam would show as a jump at one of them.
  const auto step = [&](int ring, int side) {
    const auto at = [&](int r) {
      return knot.positions[static_cast<std::size_t>(r % segments * sides + side)];
    };
    return at(ring + 1) - at(ring);
  };
  for (int ring = 0; ring < segments; ++ring) {
    for (int side = 0; side < sides; ++side) {
      const Vector one = step(ring, side), next = step(ring + 1, side);
      EXPECT_LT(glm::length(next - one), 0.25 * glm::length(one)) << ring << " " << side;
    }
  }
}

TEST(Shapes, LetterFReadsCorrectlyFromTheFront) {
  const Mesh letter = makeLetterF(5, 1);
  EXPECT_EQ(boundingBox(letter.positions).size(), Vector(3, 1, 5));
  // Volume by blocks: a stem of 5, an upper arm of 2, a lower arm of 1.5.
  EXPECT_NEAR(signedVolume(letter), 8.5, 1e-12);
  // Looking along +y with z up, right is +x: the arms point right and are in the upper half.
  double rightOfStem = 0, weight = 0;
  for (const Triangle& t : letter.triangles) {
    const Vector area = areaVector(letter.positions, t);
    if (area.y >= 0) continue;  // only the front
    const Point centre = (letter.positions[t[0]] + letter.positions[t[1]] + letter.positions[t[2]]) / 3.0;
    if (centre.x > -0.5) {
      rightOfStem += -area.y * centre.z;
      weight += -area.y;
    }
  }
  EXPECT_GT(weight, 0);
  EXPECT_GT(rightOfStem / weight, 1);
}

TEST(Shapes, PawnStandsOnAFlatFootAndIsRound) {
  const Mesh pawn = makePawn(2, 48);
  const Box box = boundingBox(pawn.positions);
  EXPECT_NEAR(box.min.z, -1, 1e-12);
  EXPECT_NEAR(box.max.z, 1, 1e-12);
  EXPECT_NEAR(box.size().x, box.size().y, 1e-12);
  EXPECT_LT(box.size().x, box.size().z);
}

TEST(Shapes, FinerIsFiner) {
  EXPECT_GT(makePawn(1, 96).triangles.size(), 3 * makePawn(1, 48).triangles.size());
  EXPECT_EQ(makeLetterF(1, 4).triangles.size(), 16 * makeLetterF(1, 1).triangles.size());
}

TEST(Shapes, ArgumentsOutOfRangeAreProgrammingErrors) {
  EXPECT_THROW(makeBox({1, 1, 1}, 0), ProgrammingError);
  EXPECT_THROW(makeBox({1, -1, 1}, 1), ProgrammingError);
  EXPECT_THROW(makeSphere(1, 2), ProgrammingError);
  EXPECT_THROW(makeSphere(0, 8), ProgrammingError);
  EXPECT_THROW(makeTorusKnot(2, 4, 0.2, 64, 8), ProgrammingError);
  EXPECT_THROW(makeTorusKnot(2, 3, 0.2, 2, 8), ProgrammingError);
  EXPECT_THROW(makeLetterF(1, 0), ProgrammingError);
  EXPECT_THROW(makePawn(1, 2), ProgrammingError);
}

TEST(Shapes, BlocksWithACavityHaveTwoSurfaces) {
  const std::vector<double> planes{0, 1, 2, 3};
  const auto isShell = [](const std::array<int, 3>& b) { return b != std::array{1, 1, 1}; };
  const Mesh shell = makeBlockShape({planes, planes, planes}, isShell, 2);
  EXPECT_TRUE(isClosed(shell));
  EXPECT_NEAR(signedVolume(shell), 26, 1e-12);
  EXPECT_EQ(eulerCharacteristic(shell), 4);
}

}  // namespace
}  // namespace anamorph
