#include "edit/mirror_import.h"

#include <gtest/gtest.h>

#include "cli/program.h"
#include "error_text.h"
#include "geometry/mesh_files.h"
#include "geometry/shapes.h"
#include "level/level_json.h"
#include "level/limits.h"
#include "optics/mesh_mirror.h"
#include "optics/sphere.h"

namespace anamorph {
namespace {

using namespace testing;

class MirrorImports : public ::testing::Test {
 protected:
  MirrorImports() { saveMesh(folder / "ball.obj", makeSphere(0.001, 96)); }
  EditResult import(const std::string& name) const {
    return importMirror({name, folder / "level.json"}, Level{});
  }
  TemporaryFolder folder;
};

TEST_F(MirrorImports, FitIntoTheOldOnesPlace) {
  const EditResult result = import("ball.obj");
  ASSERT_TRUE(result.level);
  const auto* mirror = result.level->optic.shape().as<MeshMirror>();
  ASSERT_TRUE(mirror);
  EXPECT_EQ(mirror->file.path, "ball.obj");
  EXPECT_EQ(findProblem(result.level->optic), std::nullopt);
  const Box room = boxOf(Level{}.optic), box = boxOf(result.level->optic);
  EXPECT_LT(glm::length(box.centre() - room.centre()), 1e-9);
  EXPECT_NEAR(box.size().z, room.size().z, 1e-9);
  EXPECT_EQ(result.message, "The mirror is ball.obj; Ctrl+Z takes it back.");
  saveLevel(folder / "level.json", *result.level);  // what is made can be saved
}

TEST_F(MirrorImports, TakeThePlaceOfAFileThatIsMissing) {
  const Placement placement{{1, 2, 3}, {10, 20, 30}, {4000, 4000, 5000}};
  Level level;
  level.optic.shape() = MeshMirror{{"gone.obj", nullptr, "cannot open"}, placement};
  const EditResult result = importMirror({"ball.obj", folder / "level.json"}, level);
  ASSERT_TRUE(result.level);
  const auto* mirror = result.level->optic.shape().as<MeshMirror>();
  ASSERT_TRUE(mirror);
  EXPECT_EQ(mirror->file.path, "ball.obj");
  EXPECT_EQ(mirror->placement, placement) << "it stands as the missing one did";
  EXPECT_EQ(findProblem(result.level->optic), std::nullopt);
}

// Its own middle is a hundred thousand times as far away as it is large.
TEST_F(MirrorImports, FarFromTheirOriginCanBeSavedAndRead) {
  Mesh far = makeSphere(0.1, 48);
  for (std::size_t i = 0; i < far.positions.size(); ++i)
    far.positions.set(i, far.positions[i] + Vector(1e4, 0, 0));
  saveMesh(folder / "far.obj", far);
  Level level;
  level.optic.shape() = SphereMirror{{0, 0, 0}, 100};
  const EditResult result = importMirror({"far.obj", folder / "level.json"}, level);
  ASSERT_TRUE(result.level);
  const Placement placement = result.level->optic.shape().as<MeshMirror>()->placement;
  EXPECT_NEAR(placement.scale.x, 1000, 10) << "as large as the old one";
  EXPECT_EQ(placement.position.x, limits::coordinates.min) << "as near to it as a level allows";
  saveLevel(folder / "level.json", *result.level);
  const Level read = loadLevel(folder / "level.json").level;
  EXPECT_EQ(read.optic.shape().as<MeshMirror>()->placement, placement);
}

TEST_F(MirrorImports, ThatCannotBeUsedChangeNothing) {
  EXPECT_EQ(errorOf([&] { import("gone.obj"); }),
            folder / "gone.obj" + ": cannot open: No such file or directory");
}

}  // namespace
}  // namespace anamorph
