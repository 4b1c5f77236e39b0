#include "pipeline/original.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

TEST(Original, EveryBuiltInShapeIsClosed) {
  for (const OriginalShape& shape :
       {OriginalShape(BoxShape{}), OriginalShape(SphereShape{}), OriginalShape(TorusKnotShape{}),
        OriginalShape(LetterFShape{}), OriginalShape(PawnShape{})}) {
    const auto mesh = loadOriginal(shape, "level.json").mesh;
    EXPECT_TRUE(isClosed(*mesh)) << shape.index();
    EXPECT_GT(signedVolume(*mesh), 0) << shape.index();
  }
}

TEST(Original, FileLiesBesideTheLevel) {
  const std::string level = std::string(ANAMORPH_TEST_DATA) + "/meshes/level.json";
  EXPECT_EQ(loadOriginal(FileShape{"cube.obj"}, level).mesh->positions.size(), 8u);
  EXPECT_THROW(loadOriginal(FileShape{"nothing.obj"}, level), Error);
}

TEST(Original, AFileStandsUpAsItsShapeSays) {
  const std::string level = std::string(ANAMORPH_TEST_DATA) + "/field/level.json";
  const auto lying = loadOriginal(FileShape{"obj-y-up/house.obj"}, level);
  EXPECT_EQ(lying.up.up, ModelUp::y);
  const auto standing = loadOriginal(FileShape{.path = "obj-y-up/house.obj", .up = ModelUp::y}, level).mesh;
  EXPECT_EQ(boundingBox(standing->positions).size(), Vector(2, 1, 1.8));
  EXPECT_EQ(standing->triangles, lying.mesh->triangles);
  EXPECT_NEAR(signedVolume(*standing), signedVolume(*lying.mesh), 1e-12) << "turned, not mirrored";
}

TEST(Original, WarningsOfItsFileComeWithIt) {
  const std::string level = std::string(ANAMORPH_TEST_DATA) + "/field/level.json";
  const std::string file = "obj-face-of-two/house.obj";
  const LoadedOriginal loaded = loadOriginal(FileShape{file}, level);
  EXPECT_EQ(loaded.mesh->triangles.size(), 16u);
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_NE(loaded.warnings[0].find("1 face of fewer than three corners left out"), std::string::npos);
  EXPECT_TRUE(loadOriginal(BoxShape{}, level).warnings.empty());
}

TEST(Original, PlacedAfterUnitizing) {
  const auto placed = placeOriginal(makeBox({6, 2, 2}, 1), true, {.position = {1, 2, 3}, .scale = Vector(2)});
  const Box box = boundingBox(placed->positions);
  EXPECT_EQ(box.centre(), Point(1, 2, 3));
  EXPECT_NEAR(box.size().x, 2, 1e-15);
  EXPECT_NEAR(box.size().y, 2.0 / 3, 1e-15);
}

TEST(FitInto, KeepsProportions) {
  Box target;
  target.extend({10, 10, 10});
  target.extend({14, 20, 20});
  const Box box = boundingBox(fitInto(makeBox({2, 1, 1}, 1), target).positions);
  EXPECT_EQ(box.size(), Vector(4, 2, 2));
  EXPECT_EQ(box.centre(), target.centre());
}

}  // namespace
}  // namespace anamorph
