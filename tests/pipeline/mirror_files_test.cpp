#include "pipeline/mirror_files.h"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/mesh_files.h"
#include "geometry/shapes.h"
#include "level/freeze.h"
#include "level/level_json.h"
#include "level/surface_files.h"
#include "optics/mesh_mirror.h"
#include "pipeline/original.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

class MirrorFiles : public ::testing::Test {
 protected:
  MirrorFiles() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "meshes");
    saveMesh(folder_ / "meshes/ball.obj", makeSphere(2, 96));
  }
  ~MirrorFiles() override { fs::remove_all(folder_); }

  Level levelWith(const std::string& path) const {
    Level level;
    level.optic.shape() = MeshMirror{{path, nullptr, {}}, {}};
    return level;
  }
  std::vector<std::string> read(Level& level) const { return readMirrorFiles(level, levelPath_); }
  std::string problemOf(const std::string& path) const {
    Level level = levelWith(path);
    read(level);
    return findProblem(level.optic).value_or("");
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  const fs::path folder_ = fs::path(::testing::TempDir()) / ("mirror-files" + std::to_string(::getpid()));
  const fs::path levelPath_ = folder_ / "level.json";
};

TEST_F(MirrorFiles, AreReadFromTheFolderOfTheLevel) {
  Level level = levelWith("meshes/ball.obj");
  EXPECT_EQ(read(level), std::vector<std::string>{});
  EXPECT_EQ(findProblem(level.optic), std::nullopt);
  EXPECT_NEAR(boxOf(level.optic).size().z, 4, 1e-9);
  EXPECT_EQ(surfaceFilesOf(level, levelPath_), std::vector<fs::path>{folder_ / "meshes/ball.obj"});
}

TEST_F(MirrorFiles, OfAFrozenSculptureToo) {
  Level level = frozen(levelWith("meshes/ball.obj"));
  read(level);
  EXPECT_EQ(findProblem(level.sculpture.frozen->optic), std::nullopt);
  EXPECT_EQ(level.sculpture.frozen->optic, level.optic);
}

TEST_F(MirrorFiles, ThatCannotBeReadAreToldByTheMirror) {
  const std::string in = "the mesh mirror cannot be used: " + folder_.string() + "/";
  EXPECT_EQ(problemOf("gone.obj"), in + "gone.obj: cannot open: No such file or directory.");
  fs::create_directories(folder_ / "folder.obj");
  EXPECT_EQ(problemOf("folder.obj"), in + "folder.obj: expected a file, got a folder.");
  ASSERT_EQ(::mkfifo((folder_ / "pipe.obj").c_str(), 0600), 0);
  EXPECT_EQ(problemOf("pipe.obj"), in + "pipe.obj: expected a file, got a pipe.");
  write("empty.obj", "");
  EXPECT_EQ(problemOf("empty.obj"), in + "empty.obj: expected a mesh, got an empty file.");
  write("points.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\n");
  EXPECT_NE(
      problemOf("points.obj").find(in + "points.obj: expected at least one triangle, got a point cloud of 3"),
      std::string::npos)
      << problemOf("points.obj");
  EXPECT_NE(problemOf("notes.txt").find("expected a file name that ends in .obj, .stl or .ply"),
            std::string::npos);
}

TEST_F(MirrorFiles, SayWhatTheReaderHasToSayAndThatTheyHaveKinks) {
  saveMesh(folder_ / "coarse.obj", makeSphere(2, 12));
  Level level = levelWith("coarse.obj");
  const auto warnings = read(level);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("coarse.obj: some triangles lean by"), std::string::npos) << warnings[0];
  EXPECT_EQ(findProblem(level.optic), std::nullopt) << "it can be used all the same";
  write("odd.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nf 1 2\n");
  level = levelWith("odd.obj");
  EXPECT_EQ(read(level), std::vector<std::string>{(folder_ / "odd.obj").string() +
                                                  ": line 5: 1 face of fewer than three corners left out"});
}

TEST_F(MirrorFiles, AreTakenFromALevelThatHasReadThem) {
  Level known = levelWith("meshes/ball.obj"), level = known;
  read(known);
  fs::remove(folder_ / "meshes/ball.obj");
  EXPECT_FALSE(takeMirrorFiles(level, known));
  EXPECT_EQ(level, known);
  level = levelWith("other.obj");
  EXPECT_TRUE(takeMirrorFiles(level, known)) << "it has another one";
}

TEST_F(MirrorFiles, SurviveSavingAndLoading) {
  Level level = levelWith("meshes/ball.obj");
  auto mirror = *level.optic.shape().as<MeshMirror>();
  mirror.placement = {{1, 2, 3}, {10, 20, 30}, {1, 2, 1}};
  level.optic.shape() = mirror;
  saveLevel(levelPath_, level);
  Level again = loadLevel(levelPath_).level;
  EXPECT_EQ(again, level);
  read(level);
  read(again);
  EXPECT_EQ(again, level);
}

TEST_F(MirrorFiles, APlacementNeedNotBeInTheFile) {
  write("level.json", R"({"format": "anamorph-level", "version": 2,
    "optic": {"kind": "mirror", "shape": {"type": "mesh", "path": "meshes/ball.obj"}},
    "camera": {"eye": [0, -11, 8], "target": [0, 3, 1]}, "original": {"shape": {"type": "box"}}})");
  Level level = loadLevel(levelPath_).level;
  read(level);
  EXPECT_EQ(level.optic.shape().as<MeshMirror>()->placement, Placement{});
}

}  // namespace
}  // namespace anamorph
