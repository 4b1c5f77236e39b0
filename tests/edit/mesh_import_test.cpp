#include "edit/mesh_import.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

using namespace testing;
using ::testing::HasSubstr;

const std::string field = std::string(ANAMORPH_TEST_DATA) + "/field/";

Box placedBox(const Level& level) {
  const auto mesh = loadOriginal(level.original.shape, {}).mesh;
  return boundingBox(placeOriginal(*mesh, level.original.unitize, level.original.placement)->positions);
}

EditResult import(const std::string& file, const Level& level) {
  return importMesh({.file = file, .name = file, .levelPath = {}, .box = placedBox(level)}, level);
}

const FileShape& fileOf(const Level& level) {
  return std::get<FileShape>(level.original.shape);
}

TEST(MeshImport, StandsUpWhatLiesAndSaysSo) {
  const EditResult result = import(field + "obj-y-up/house.obj", Level{});
  ASSERT_TRUE(result.level && result.between);
  EXPECT_EQ(fileOf(*result.level).up, ModelUp::y);
  EXPECT_EQ(fileOf(*result.between).up, ModelUp::z) << "what undoing leads to first";
  EXPECT_THAT(result.message, HasSubstr("10 vertices, 16 triangles. Its y axis is taken to point up"));
  EXPECT_THAT(result.message, HasSubstr("Ctrl+Z"));
  const Vector size = placedBox(*result.level).size(), lying = placedBox(*result.between).size();
  EXPECT_NEAR(size.z / size.x, 0.9, 1e-9);
  EXPECT_NEAR(lying.z / lying.x, 0.5, 1e-9);
}

TEST(MeshImport, LeavesWhatStands) {
  const EditResult result = import(field + "obj-bom/house.obj", Level{});
  ASSERT_TRUE(result.level);
  EXPECT_FALSE(result.between);
  EXPECT_EQ(fileOf(*result.level).up, ModelUp::z);
}

TEST(MeshImport, AnotherMeshKeepsRotationAndScale) {
  Level level = *import(field + "obj-bom/house.obj", Level{}).level;
  Placement& placement = level.original.placement;
  placement.rotationDegrees = {0, 0, 35};
  placement.scale = placement.scale * Vector(1, 1, 0.7);
  for (const char* name : {"obj-tab-separated/house.obj", "obj-y-up/house.obj"}) {
    SCOPED_TRACE(name);
    const Level other = *import(field + name, level).level;
    EXPECT_EQ(other.original.placement.rotationDegrees, placement.rotationDegrees);
    EXPECT_EQ(other.original.placement.scale, placement.scale);
    EXPECT_LT(glm::length(placedBox(other).centre() - placedBox(level).centre()), 1e-9);
  }
  // In other units the numbers say nothing: as large as the old one, and in its proportions.
  const Level tiny = *import(field + "obj-tiny/house.obj", level).level;
  EXPECT_EQ(tiny.original.placement.rotationDegrees, placement.rotationDegrees);
  EXPECT_NEAR(tiny.original.placement.scale.z / tiny.original.placement.scale.x, 0.7, 1e-9);
  EXPECT_LT(glm::length(placedBox(tiny).size() - placedBox(level).size()), 1e-6);
}

TEST(MeshImport, TheSameFileAgainStandsAsItWasPut) {
  const TemporaryFolder folder;
  const std::string file = folder / "house.obj";
  writeText(file, readAll(field + "obj-y-up/house.obj"));
  for (const ModelUp up : {ModelUp::z, ModelUp::x}) {
    Level level = *import(file, Level{}).level;
    std::get<FileShape>(level.original.shape).up = up;
    const EditResult again = import(file, level);
    EXPECT_FALSE(again.between);
    EXPECT_EQ(fileOf(*again.level).up, up);
    EXPECT_EQ(again.level->original.placement.scale, level.original.placement.scale);
  }
}

TEST(MeshImport, AThesisSceneSaysHowItsMeshStands) {
  const EditResult result = importMesh({.file = field + "obj-y-up/house.obj",
                                        .name = "house.obj",
                                        .levelPath = {},
                                        .box = {},
                                        .keepSize = true},
                                       Level{});
  EXPECT_FALSE(result.between);
  EXPECT_EQ(fileOf(*result.level).up, ModelUp::z);
  EXPECT_EQ(result.level->original.placement, Level{}.original.placement);
}

}  // namespace
}  // namespace anamorph
