#include "edit/replacements.h"

#include <string>

#include <gtest/gtest.h>

#include "edit/edit_levels.h"
#include "geometry/shapes.h"
#include "level/level_json.h"
#include "level/mirror_kind.h"
#include "optics/shape_table.h"
#include "pipeline/original.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(MirrorOfKind, KeepsPlaceAndSizeAndIsSound) {
  for (const ShapeKind from : allShapeKinds) {
    for (std::size_t to = 0; to < shapeTypes().size(); ++to) {
      if (shapeTypes()[to].needsFile) continue;
      for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(std::to_string(int(from)) + " to " + std::to_string(to) + ", seed " +
                     std::to_string(seed));
        Random random(seed);
        const Level level = makeRandomLevel(from, random);
        const Shape& old = level.optic.shape();
        const Shape made = mirrorOfKind(to, old, level.camera.eye);
        ASSERT_EQ(shapeIndex(made), to);
        if (shapeIndex(old) == to) {
          EXPECT_EQ(made, old);
          continue;
        }
        EXPECT_EQ(findShapeProblem(made), std::nullopt);
        EXPECT_LT(glm::length(middleOf(made) - middleOf(old)), 1e-9);
        const Box was = boundingBox(tessellate(old).mesh.positions),
                  is = boundingBox(tessellate(made).mesh.positions);
        EXPECT_LE(is.diagonal(), 1.75 * was.diagonal());
        EXPECT_GE(is.diagonal(), 0.05 * was.diagonal());
        if (to != 0) {
          EXPECT_EQ(findEyeProblem(made, level.camera.eye), std::nullopt) << "the eye stays outside";
          EXPECT_LE(extentOf(made).width, 1.01 * was.diagonal());
        }
      }
    }
  }
}

TEST(MirrorOfKind, OfTheLevelsMirrorIsAsWideAndHigh) {
  const PlaneMirror plane{{Point(-4, 0, 0), Point(4, 0, 0), Point(4, 0, 10), Point(-4, 0, 10)}};
  const Point eye(0, -40, 5);
  const auto tube = shapeAs<CylinderMirror>(mirrorOfKind(1, plane, eye));
  EXPECT_EQ(tube, (CylinderMirror{{0, 0, 0}, {0, 0, 10}, 4}));
  EXPECT_EQ(shapeAs<SphereMirror>(mirrorOfKind(2, tube, eye)), (SphereMirror{{0, 0, 5}, 4}));
  const auto back = shapeAs<PlaneMirror>(mirrorOfKind(0, tube, eye));
  for (int i = 0; i < 4; ++i) EXPECT_LT(glm::length(back.corners[i] - plane.corners[i]), 1e-12) << i;
}

TEST(MirrorOfKind, IsSoundWhateverTheOldOneIs) {
  for (const Level& level : makeAbsurdLevels()) {
    for (std::size_t to = 0; to < shapeTypes().size(); ++to) {
      const Shape made = mirrorOfKind(to, level.optic.shape(), level.camera.eye);
      if (shapeTypes()[to].needsFile) {
        EXPECT_EQ(made, level.optic.shape()) << "it waits for a file";
      } else if (to != shapeIndex(level.optic.shape())) {
        EXPECT_EQ(findShapeProblem(made), std::nullopt) << to;
      }
    }
  }
}

Box placedBox(const Level& level) {
  const auto mesh = loadOriginal(level.original.shape, {}).mesh;
  return boundingBox(placeOriginal(*mesh, level.original.unitize, level.original.placement)->positions);
}

TEST(WithOriginal, FitsTheOldOnesBox) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    Level level = makeRandomLevel(ShapeKind::plane, random);
    level.original.unitize = seed % 2 == 0;
    const Box old = placedBox(level);
    for (std::size_t kind = 0; kind < 5; ++kind) {
      SCOPED_TRACE("kind " + std::to_string(kind) + ", seed " + std::to_string(seed));
      const Level made = withBuiltInOriginal(level, kind, old);
      ASSERT_EQ(made.original.shape.index(), kind);
      const Box box = placedBox(made);
      EXPECT_LT(glm::length(box.centre() - old.centre()), 1e-6 * old.diagonal());
      double fullest = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double fraction = box.size()[axis] / old.size()[axis];
        EXPECT_LE(fraction, 1 + 1e-9);
        fullest = std::max(fullest, fraction);
      }
      EXPECT_NEAR(fullest, 1, 1e-6) << "as large as fits";
      EXPECT_EQ(made.original.material, level.original.material);
      EXPECT_NO_THROW(parseLevel(formatLevel(made), "made"));
    }
  }
}

TEST(WithOriginal, FitsAMeshAsTheCommandsDo) {
  Random random(3);
  const Level level = makeRandomLevel(ShapeKind::sphere, random);
  const Box old = placedBox(level);
  Mesh mesh = makeTorusKnot(2, 3, 0.3, 40, 8);
  mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return 17.0 * p + Point(100, -3, 8); });
  const Level made = withOriginal(level, FileShape{"knot.obj"}, mesh, old);
  const Mesh expected = fitInto(mesh, old);
  const auto placed = placeOriginal(mesh, made.original.unitize, made.original.placement);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    ASSERT_LT(glm::length(placed->positions[i] - expected.positions[i]), 1e-9);
}

TEST(WithOriginal, FitsIntoARoomWithoutDepth) {
  Mesh mesh = makeBox({1000, 500, 800}, 1);
  Box flat;
  flat.extend(Point(-1, 0, 2));
  flat.extend(Point(1, 0, 6));
  const Level made = withOriginal(Level(), FileShape{"box.obj"}, mesh, flat);
  const auto placed = placeOriginal(mesh, made.original.unitize, made.original.placement);
  const Box box = boundingBox(placed->positions);
  EXPECT_NEAR(box.size().x, 2, 1e-9);
  EXPECT_LE(box.size().z, 4);
  EXPECT_NEAR(boundingBox(fitInto(mesh, flat).positions).size().x, 2, 1e-9);
}

TEST(WithOriginal, WithoutABoxStandsWhereTheOldOneStood) {
  Level level;
  const Level made = withBuiltInOriginal(level, 1, Box{});
  EXPECT_EQ(made.original.placement.position, level.original.placement.position);
  EXPECT_EQ(std::get<SphereShape>(made.original.shape), SphereShape{});
  const Level none = withOriginal(level, FileShape{"x.obj"}, Mesh{}, placedBox(level));
  EXPECT_EQ(none.original.placement.position, level.original.placement.position);
}

}  // namespace
}  // namespace anamorph
