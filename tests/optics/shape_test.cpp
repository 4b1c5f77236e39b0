#include "optics/shape.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "optics/optic.h"
#include "random_scene.h"
#include "shapes.h"
#include "surface_of.h"

namespace anamorph {
namespace {

using namespace testing;
using ::testing::HasSubstr;

TEST(Shapes, PlaneIsHitInsideItsQuadOnly) {
  const PlaneMirror plane;  // x and z from -1 to 1 at y = 0
  const auto hit = intersect(plane, {{0.5, -2, 0.25}, {0, 1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->t, 2);
  EXPECT_EQ(hit->point, Point(0.5, 0, 0.25));
  EXPECT_EQ(hit->normal, Direction(0, -1, 0));
  EXPECT_FALSE(intersect(plane, {{1.5, -2, 0}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(plane, {{0, -2, 0}, {0, -1, 0}}));
  EXPECT_FALSE(intersect(plane, {{0, -2, 0}, {1, 0, 0}})) << "parallel to the plane";
}

TEST(Shapes, BothSidesOfThePlaneReflect) {
  const auto hit = intersect(PlaneMirror{}, {{0, 3, 0}, {0, -1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->normal, Direction(0, 1, 0));
}

TEST(Shapes, DirectionLengthIsTheUnitOfT) {
  const auto hit = intersect(SphereMirror{Point(0), 1}, {{0, -5, 0}, {0, 8, 0}});
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->t, 0.5);
  EXPECT_EQ(hit->normal, Direction(0, -1, 0));
}

TEST(Shapes, CylinderEndsAtItsEnds) {
  const CylinderMirror tube{{0, 0, 0}, {0, 0, 2}, 1};
  EXPECT_TRUE(intersect(tube, {{0, -5, 1.9}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(tube, {{0, -5, 2.1}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(tube, {{0, -5, -0.1}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(tube, {{0, 0, -5}, {0, 0, 1}})) << "along the axis";
}

TEST(Shapes, OpenTubeIsHitFromInsideThroughItsEnd) {
  const CylinderMirror tube{{0, 0, 0}, {0, 0, 2}, 1};
  const auto hit = intersect(tube, {{0, -2, 3}, glm::normalize(Vector(0, 1, -0.6))});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->point.y, 1, 1e-12) << "over the near rim, on to the far wall";
  EXPECT_NEAR(hit->normal.y, -1, 1e-12);
}

TEST(Shapes, HitsLieOnTheSurfaceWithUnitNormalsTowardsTheRay) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 1000; ++seed) {
      SCOPED_TRACE("kind " + std::to_string(int(kind)) + " seed " + std::to_string(seed));
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      const auto hit = intersect(scene.optic.shape(), {scene.eye, scene.onMirror - scene.eye});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->t, 1, 1e-12);
      EXPECT_LT(glm::length(hit->point - scene.onMirror), 1e-12 * 40);
      EXPECT_LT(glm::length(hit->normal - scene.normal), 1e-12);
      EXPECT_NEAR(glm::length(hit->normal), 1, 1e-12);
    }
  }
}

TEST(Shapes, TessellationLiesOnTheSurface) {
  Random random(1);
  for (const ShapeKind kind : allShapeKinds) {
    const RandomScene scene = makeRandomScene(kind, random);
    const Mesh mesh = tessellate(scene.optic.shape(), 24).mesh;
    ASSERT_FALSE(mesh.triangles.empty());
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      const Point p = mesh.positions[i];
      double off = 0;
      if (const auto* plane = scene.optic.shape().as<PlaneMirror>()) {
        off = glm::dot(p - plane->corners[0], plane->normal());
      } else {
        off = surfaceOf(scene.optic.shape()).value(p);
      }
      EXPECT_NEAR(off, 0, 1e-12);
    }
  }
}

TEST(MirrorProblems, SoundShapesHaveNone) {
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 100; ++seed) {
      Random random(seed);
      const RandomScene scene = makeRandomScene(kind, random);
      EXPECT_EQ(findShapeProblem(scene.optic.shape()), std::nullopt);
      EXPECT_EQ(findEyeProblem(scene.optic.shape(), scene.eye), std::nullopt);
    }
  }
}

TEST(MirrorProblems, BadShapesAreNamed) {
  const Point a(0, 0, 0), b(1, 0, 0), c(1, 0, 1), d(0, 0, 1);
  const struct {
    Shape shape;
    const char* message;
  } table[] = {
      {PlaneMirror{{a, a, a, a}}, "expected four corners that span an area, got a quad of area 0"},
      {PlaneMirror{{a, b, Point(2, 0, 0), Point(3, 0, 0)}},
       "expected four corners that span an area, got a quad of area 0"},
      {PlaneMirror{{a, b, Point(1, 0.1, 1), d}}, "expected four corners in one plane, got one that is "},
      {PlaneMirror{{a, Point(1, 0, 0.9), b, d}},
       "expected a convex quad with its corners in order around it"},
      {PlaneMirror{{a, b, Point(0.2, 0, 0.2), d}},
       "expected a convex quad with its corners in order around it"},
      {CylinderMirror{a, a, 1}, "expected a top that is not at the bottom, got a cylinder of height 0"},
      {CylinderMirror{a, d, 0}, "expected a radius > 0, got 0"},
      {ConeMirror{a, a, 1, 2}, "expected a top that is not at the bottom, got a cone of height 0"},
      {ConeMirror{a, d, 1, -2}, "expected a radius of 0 or more, got -2"},
      {ConeMirror{a, d, std::nan(""), 1}, "expected a radius of 0 or more, got nan"},
      {ConeMirror{a, d, 0, 0}, "expected a bottom or a top radius > 0, got a cone of width 0"},
      {EllipsoidMirror{a, {1, 0, 1}, a}, "expected a radius > 0, got 0"},
      {ParaboloidMirror{a, a, 1, 1, 0}, "expected an axis that is not 0"},
      {ParaboloidMirror{a, d, -1, 1, 0}, "expected a focal length > 0, got -1"},
      {ParaboloidMirror{a, d, 1, 0, 0}, "expected a radius > 0, got 0"},
      {ParaboloidMirror{a, d, 1, 2, 2}, "expected an inner radius from 0 to below the radius 2, got 2"},
      {SphereMirror{a, -4}, "expected a radius > 0, got -4"},
      {SphereMirror{a, std::nan("")}, "expected a radius > 0, got nan"},
  };
  for (const auto& row : table) {
    const auto problem = findShapeProblem(row.shape);
    ASSERT_TRUE(problem) << row.message;
    EXPECT_THAT(*problem, HasSubstr(row.message));
  }
}

TEST(MirrorProblems, BadEyesAreNamedWithTheWayOut) {
  const struct {
    Shape shape;
    Point eye;
    const char* message;
  } table[] = {
      {PlaneMirror{}, {5, 0, 3}, "edge-on and nothing in it. Move the eye away from that plane."},
      {SphereMirror{Point(0), 4}, {4, 0, 0}, "on the surface of the mirror"},
      {SphereMirror{Point(0), 4},
       {0, 4 * (1 - 1e-7), 0},
       "Move the eye away from the surface, to either side."},
      {SphereMirror{Point(0), 4},
       {5e6, 0, 0},
       "the mirror's radius 4 is too small for an eye that is 5000000 away"},
      {CylinderMirror{{0, 0, 0}, {0, 0, 1}, 10}, {0, 10, 0.5}, "on the surface of the mirror"},
      {ConeMirror{{0, 0, 0}, {0, 0, 10}, 10, 5}, {0, 6, 8}, "on the surface of the mirror"},
      {EllipsoidMirror{{0, 0, 0}, {1, 2, 3}, {0, 0, 90}}, {2, 0, 0}, "on the surface of the mirror"},
      {ParaboloidMirror{{0, 0, 0}, {0, 0, 1}, 1, 2, 0}, {0, 0, 0}, "on the surface of the mirror"},
      {ParaboloidMirror{{0, 0, 0}, {0, 0, 1}, 1, 2, 0}, {3e6, 0, 0}, "radius 2 is too small"},
  };
  for (const auto& row : table) {
    const auto problem = findEyeProblem(row.shape, row.eye);
    ASSERT_TRUE(problem) << row.message;
    EXPECT_THAT(*problem, HasSubstr(row.message));
  }
}

// Both sides reflect: from within a mirror, or from where it has ended, there is something to see.
TEST(MirrorProblems, AnEyeWithinOrBesideTheEndIsNone) {
  const struct {
    Shape shape;
    Point eye;
  } table[] = {
      {SphereMirror{Point(0), 4}, {1, 0, 0}},
      {CylinderMirror{{0, 0, 0}, {0, 0, 1}, 10}, {0, 5, 7}},
      {CylinderMirror{{0, 0, 0}, {0, 0, 1}, 10}, {0, 10, 7}},
      {ConeMirror{{0, 0, 0}, {0, 0, 10}, 10, 5}, {0, 5, 8}},
      {ConeMirror{{0, 0, 0}, {0, 0, 10}, 10, 5}, {0, 3, 12}},
      {EllipsoidMirror{{0, 0, 0}, {1, 2, 3}, {0, 0, 90}}, {0, 0, 0}},
      {ParaboloidMirror{{0, 0, 0}, {0, 0, 1}, 1, 2, 0}, {0, 0, 1}},
      {ParaboloidMirror{{0, 0, 0}, {0, 0, 1}, 1, 2, 0.5}, {0, 0, 0}},
  };
  for (const auto& row : table)
    EXPECT_EQ(findEyeProblem(row.shape, row.eye), std::nullopt) << shapeName(row.shape);
}

TEST(MirrorProblems, AnEyeOnTheSurfaceFindsAWayOff) {
  for (const ShapeKind kind : curvedShapeKinds) {
    for (unsigned seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE("kind " + std::to_string(int(kind)) + " seed " + std::to_string(seed));
      Random random(seed);
      const Shape shape = makeRandomScene(kind, random).optic.shape();
      const Point eye = pointAt(shape, random.uniform(0, 1), random.uniform(0, 1));
      ASSERT_TRUE(findEyeProblem(shape, eye));
      EXPECT_EQ(findEyeProblem(shape, eyeOutside(shape, eye, random.point(10))), std::nullopt);
    }
  }
}

TEST(CutShape, KeepsItsPlanesAsTheyAreWhileItOnlyMoves) {
  Shape half = SphereMirror{{1, 2, 3}, 2};
  half.clipBy({{{1, 2, 3}, {0.3, 0, 2}}});
  const Shape moved = mapShape(half, {[](const Point& p) { return p + Vector(0.1, 1e3, 1.0 / 3); }});
  EXPECT_EQ(moved.clip().front().normal, half.clip().front().normal);
  const Shape turned = mapShape(half, {[](const Point& p) { return Point(p.x, -p.z, p.y); }});
  EXPECT_LT(glm::length(turned.clip().front().normal - Vector(0.3, -2, 0)), 1e-12)
      << "and their length when it turns";
}

TEST(CutShape, OfABallStillHasOneSize) {
  Shape half = SphereMirror{};
  EXPECT_TRUE(hasOneSize(half));
  EXPECT_TRUE(isRound(half));
  half.clipBy({{{0, 0, 0}, {0, 0, 1}}});
  EXPECT_TRUE(hasOneSize(half));
  EXPECT_FALSE(isRound(half)) << "it can be turned";
}

}  // namespace
}  // namespace anamorph
