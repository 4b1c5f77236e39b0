#include "viewport/canvas_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(CanvasLines, AreOnlyThereWithoutAMirror) {
  const Shape shapes[] = {PlaneMirror{}, CylinderMirror{}, SphereMirror{}};
  for (const Shape& shape : shapes) {
    EXPECT_TRUE(makeCanvasLines({OpticKind::mirror, shape}, false).empty());
    EXPECT_FALSE(makeCanvasLines({OpticKind::canvas, shape}, false).empty());
  }
  CylinderMirror flat;
  flat.top = flat.bottom;
  EXPECT_TRUE(makeCanvasLines({OpticKind::canvas, flat}, false).empty());
}

TEST(CanvasLines, BeginAndEndOnTheSurface) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const SphereMirror sphere{random.point(20), random.uniform(0.1, 5)};
    for (const Line& line : makeCanvasLines({OpticKind::canvas, sphere}, false)) {
      EXPECT_NEAR(glm::length(line.from - sphere.centre), sphere.radius, 1e-9);
      EXPECT_NEAR(glm::length(line.to - sphere.centre), sphere.radius, 1e-9);
    }
    CylinderMirror cylinder;
    cylinder.bottom = random.point(20);
    cylinder.top = cylinder.bottom + random.uniform(0.1, 9) * random.direction();
    cylinder.radius = random.uniform(0.1, 5);
    const Direction axis = glm::normalize(cylinder.top - cylinder.bottom);
    const double height = glm::length(cylinder.top - cylinder.bottom);
    for (const Line& line : makeCanvasLines({OpticKind::canvas, cylinder}, false)) {
      for (const Point& point : {line.from, line.to}) {
        const double up = glm::dot(point - cylinder.bottom, axis);
        EXPECT_NEAR(glm::length(point - cylinder.bottom - up * axis), cylinder.radius, 1e-9);
        EXPECT_GE(up, -1e-9);
        EXPECT_LE(up, height + 1e-9);
      }
    }
  }
}

TEST(CanvasLines, OfAMeshAreSomeOfItsTriangles) {
  for (const int segments : {8, 96}) {
    const Mesh ball = makeSphere(2, segments);
    const auto lines = makeCanvasLines({OpticKind::canvas, meshMirror(withSmoothNormals(ball))}, false);
    EXPECT_GE(lines.size(), 3 * std::min<std::size_t>(ball.triangles.size(), 100));
    EXPECT_LE(lines.size(), 3000u);
    for (const Line& line : lines) {
      EXPECT_NEAR(glm::length(line.from), 2, 1e-9);
      EXPECT_NEAR(glm::length(line.to), 2, 1e-9);
    }
  }
}

TEST(CanvasLines, AreNotThereWhereTheCanvasIsCutAway) {
  Shape half = SphereMirror{};
  const std::size_t whole = makeCanvasLines({OpticKind::canvas, half}, false).size();
  half.clipBy({{middleOf(half), {0, 0, 1}}});
  const auto lines = makeCanvasLines({OpticKind::canvas, half}, false);
  EXPECT_GT(lines.size(), whole / 3);
  EXPECT_LT(lines.size(), whole);
  for (const Line& line : lines) EXPECT_GE(line.from.z + line.to.z, -1e-9);
}

TEST(CanvasLines, OfAPlaneHaveItsCornersAndAreOrangeWhenSelected) {
  const PlaneMirror plane;
  const auto lines = makeCanvasLines({OpticKind::canvas, plane}, false);
  for (int i = 0; i < 4; ++i) {
    const Point a = plane.corners[i], b = plane.corners[(i + 1) % 4];
    const auto isSide = [&](const Line& line) {
      return (line.from == a && line.to == b) || (line.from == b && line.to == a);
    };
    EXPECT_EQ(std::count_if(lines.begin(), lines.end(), isSide), 1) << "side " << i;
  }
  const auto selected = makeCanvasLines({OpticKind::canvas, plane}, true);
  ASSERT_EQ(selected.size(), lines.size());
  EXPECT_NE(selected[0].color, lines[0].color);
  EXPECT_EQ(selected[0].from, lines[0].from);
}

}  // namespace
}  // namespace anamorph
