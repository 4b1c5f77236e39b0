// A level and its mesh: found again from other folders, sent as text, asked for where it is missing.

#include "edit/level_files.h"

#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "edit/session.h"
#include "error_text.h"
#include "geometry/mesh_files.h"
#include "geometry/shapes.h"
#include "level/freeze.h"
#include "level/level_json.h"
#include "level/random_level.h"
#include "pipeline/original.h"
#include "save_session.h"
#include "shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

const fs::path levels = ANAMORPH_LEVELS;
const fs::path meshes = fs::path(ANAMORPH_TEST_DATA) / "meshes";

// The mesh beside the level, in one folder; the level then goes to others.
class MovedLevel : public ::testing::Test {
 protected:
  MovedLevel() {
    fs::create_directories(folder / "a/meshes");
    fs::create_directories(folder / "b");
    fs::copy_file(meshes / "cube.obj", folder / "a/meshes/cube.obj");
    Level level;
    level.original.shape = FileShape{"meshes/cube.obj"};
    saveLevel(folder / "a/level.json", level);
    session.open(folder / "a/level.json");
  }
  const std::string& meshPath() const { return std::get<FileShape>(session.level().original.shape).path; }
  bool findsMesh() const {
    return loadOriginal(session.level().original.shape, session.path()).mesh->positions.size() == 8;
  }

  TemporaryFolder folder;
  Session session;
};

TEST_F(MovedLevel, FindsItsMeshFromAnotherFolder) {
  Level changed = session.level();
  changed.sculpture.depthScale = 2;
  session.edit(changed);
  testing::saveTo(session, folder / "b/level.json");
  EXPECT_EQ(meshPath(), "../a/meshes/cube.obj");
  EXPECT_TRUE(findsMesh());
  session.undo();
  EXPECT_TRUE(findsMesh()) << "the steps before the saving are of the new folder, too";
  session.redo();
  testing::saveTo(session, folder / "a/other.json");
  EXPECT_EQ(meshPath(), "meshes/cube.obj");
  EXPECT_TRUE(findsMesh());
  EXPECT_FALSE(session.modified());
}

TEST_F(MovedLevel, NamesTheSameMeshFromEveryFolder) {
  fs::create_directories(folder / "a/meshes/old");
  const char* const saved[][2] = {{"a/meshes/level.json", "cube.obj"},
                                  {"a/meshes/old/level.json", "../cube.obj"},
                                  {"level.json", "a/meshes/cube.obj"},
                                  {"b/level.json", "../a/meshes/cube.obj"}};
  for (const auto& [file, path] : saved) {
    testing::saveTo(session, folder / file);
    EXPECT_EQ(meshPath(), path) << file;
    EXPECT_TRUE(findsMesh()) << file;
    session.undo();
  }
}

// The surface that is reflected by is found again like the original's mesh, now and at every step of the history.
TEST_F(MovedLevel, FindsTheFileOfItsMirrorFromAnotherFolder) {
  saveMesh(folder / "a/meshes/ball.obj", makeSphere(1, 64));
  Level level = session.level();
  level.optic.shape() = MeshMirror{{"meshes/ball.obj", nullptr, {}}, {.position = {0, 0, 3}}};
  level = frozen(level);
  saveLevel(folder / "a/mirror.json", level);
  session.open(folder / "a/mirror.json");
  ASSERT_EQ(findProblem(session.level().optic), std::nullopt);
  level = session.level();
  level.sculpture.depthScale = 2;
  session.edit(level);
  testing::saveTo(session, folder / "b/mirror.json");
  EXPECT_FALSE(session.modified());
  session.undo();
  const Level again = readLevelFile(folder / "b/mirror.json").loaded.level;
  for (const Level& one : {session.level(), again}) {
    for (const Optic& optic : {one.optic, one.sculpture.frozen->optic}) {
      const auto* mirror = optic.shape().as<MeshMirror>();
      EXPECT_EQ(mirror->file.path, "../a/meshes/ball.obj");
      EXPECT_EQ(findProblem(optic), std::nullopt);
    }
  }
}

TEST_F(MovedLevel, AsTextNamesTheFileOfItsMirrorWithoutFolders) {
  saveMesh(folder / "a/meshes/ball.obj", makeSphere(1, 64));
  Level level = session.level();
  level.optic.shape() = MeshMirror{{(folder / "a/meshes/ball.obj"), nullptr, {}}, {}};
  const auto pathOfMirror = [](const Level& one) { return one.optic.shape().as<MeshMirror>()->file.path; };
  const Level sent = levelFromText(levelAsText(level, session.path()), {}, session.path()).level;
  EXPECT_EQ(pathOfMirror(sent), "meshes/ball.obj");
  EXPECT_EQ(pathOfMirror(levelFromText(levelAsText(level, {}), {}, "/nowhere/level.json").level), "ball.obj");
}

TEST_F(MovedLevel, IsNamedAsAWholeWhereThereIsNoFolderInCommon) {
  EXPECT_EQ(meshNameFor("/data/cube.obj", "/home/me/level.json"), "/data/cube.obj");
  EXPECT_EQ(meshNameFor("/home/me/cube.obj", "/home/me/levels/level.json"), "../cube.obj");
  EXPECT_EQ(meshNameFor("/data/cube.obj", {}), "/data/cube.obj");
}

TEST_F(MovedLevel, KeepsItsWordsInTheSameFolder) {
  Level level = session.level();
  level.original.shape = FileShape{"../a/meshes/cube.obj"};
  session.edit(level);
  testing::saveTo(session, folder / "a/again.json");
  EXPECT_EQ(meshPath(), "../a/meshes/cube.obj");
}

TEST_F(MovedLevel, FollowsLinksOfFolders) {
  fs::create_directories(folder / "far/away");
  fs::create_directory_symlink(folder / "far/away", folder / "link");
  fs::copy_file(meshes / "cube.obj", folder / "far/cube.obj");
  Level level = session.level();
  saveLevel(folder / "link/level.json", level);
  session.open(folder / "link/level.json");
  level.original.shape = FileShape{"../cube.obj"};  // of far/away, not beside the link
  session.edit(level);
  ASSERT_TRUE(findsMesh());
  testing::saveTo(session, folder / "b/level.json");
  EXPECT_TRUE(findsMesh()) << meshPath();
}

std::string pathIn(const Level& level) {
  return std::get<FileShape>(level.original.shape).path;
}

TEST_F(MovedLevel, AsTextSaysNothingOfFolders) {
  const std::string text = levelAsText(session.level(), session.path());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  EXPECT_EQ(levelFromText(text, {}, session.path()).level, session.level());
  struct {
    std::string path;
    fs::path level;
    const char* said;
  } const table[] = {{"meshes/cube.obj", folder / "a/level.json", "meshes/cube.obj"},
                     {folder / "a/meshes/cube.obj", folder / "a/level.json", "meshes/cube.obj"},
                     {"../a/meshes/cube.obj", folder / "b/level.json", "cube.obj"},
                     {folder / "a/meshes/cube.obj", {}, "cube.obj"},
                     {"/home/me/secret/cube.obj", folder / "a/level.json", "cube.obj"}};
  for (const auto& [path, file, said] : table) {
    Level level;
    level.original.shape = FileShape{path};
    const std::string sent = levelAsText(level, file);
    EXPECT_EQ(sent.find((folder / "").substr(0, 5)), std::string::npos) << sent;
    EXPECT_EQ(sent.find("secret"), std::string::npos) << sent;
    EXPECT_EQ(pathIn(levelFromText(sent, {}, "/nowhere/level.json").level), said);
  }
}

TEST_F(MovedLevel, PastedOverItselfKeepsAMeshThatLiesElsewhere) {
  Level level = session.level();
  level.original.shape = FileShape{meshes / "cube.obj"};
  const std::string text = levelAsText(level, session.path());
  EXPECT_EQ(levelFromText(text, level, session.path()).level, level);
  EXPECT_EQ(findMissingMesh(levelFromText(text, {}, session.path()).level, session.path()),
            folder / "a/cube.obj");
}

TEST_F(MovedLevel, TakesItsMeshAlong) {
  const auto mesh = loadOriginal(session.level().original.shape, session.path()).mesh;
  const Level sent = withMeshInside(session.level(), *mesh);
  const Level level = levelFromText(levelAsText(sent, session.path()), {}, "/nowhere/level.json").level;
  EXPECT_EQ(pathIn(level), "cube.obj") << "it is called so";
  EXPECT_EQ(*loadOriginal(level.original.shape, "/nowhere/level.json").mesh, *mesh);
  EXPECT_EQ(findMissingMesh(level, "/nowhere/level.json"), std::nullopt);
  session.edit(level);
  testing::saveTo(session, folder / "b/level.json");
  EXPECT_EQ(loadLevel(folder / "b/level.json").level, level) << "it stays inside";
}

// A mesh that lies on its back: turned once, not twice and not never.
TEST_F(MovedLevel, TheAxisThatPointsUpTravelsWithTheMesh) {
  Level level = session.level();
  std::get<FileShape>(level.original.shape).up = ModelUp::y;
  const auto standing = loadOriginal(level.original.shape, session.path()).mesh;
  const Level inside = withMeshInside(level, *standing);
  EXPECT_EQ(*loadOriginal(inside.original.shape, session.path()).mesh, *standing);
  Level open = level;
  open.original.shape = FileShape{meshes / "cube.obj"};
  const Level pasted = levelFromText(levelAsText(level, session.path()), open, "/nowhere/level.json").level;
  EXPECT_EQ(pasted.original.shape, OriginalShape(FileShape{.path = meshes / "cube.obj", .up = ModelUp::y}));
}

TEST_F(MovedLevel, ALargeMeshStaysInItsFile) {
  const Mesh large = makeSphere(1, 128);
  EXPECT_EQ(errorOf([&] { withMeshInside(session.level(), large); }).find("cube.obj has "), 0u);
}

TEST_F(MovedLevel, ABrokenMeshInsideIsTold) {
  Level level = session.level();
  level.original.shape = FileShape{"model.stl", std::string("v 0 0 0\nf 1 2 3\n")};
  const std::string message = errorOf([&] { loadOriginal(level.original.shape, "level.json"); });
  EXPECT_EQ(message.find("level.json: /original/shape/obj: model.obj: "), 0u) << message;
}

TEST(LevelText, BadTextsAreClearMessages) {
  for (const char* text : {"", " \n", "Hello", "{", "[1]", "{\"format\": \"anamorph-level\"}",
                           "{\"Eye\": [0, 0, 0], \"Objects\": []}"}) {
    const std::string message = errorOf([&] { levelFromText(text, {}, {}); });
    EXPECT_EQ(message.find("the text on the clipboard"), 0u) << text << ": " << message;
  }
}

TEST(LevelText, RandomLevelsComeBack) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Level level = RandomLevel(seed).make();
    if (auto* file = std::get_if<FileShape>(&level.original.shape)) file->path = "x" + std::to_string(seed);
    if (level.optic.shape().as<MeshMirror>()) continue;  // its file is read, and is not there
    if (level.sculpture.frozen && level.sculpture.frozen->optic.shape().as<MeshMirror>()) continue;
    EXPECT_EQ(levelFromText(levelAsText(level, "/somewhere/level.json"), {}, "/else/where.json").level,
              level);
  }
}

TEST(InstalledLevels, AreKnownHoweverTheirPathIsWritten) {
  EXPECT_TRUE(isInstalledLevel(levels / "1-plane.json"));
  EXPECT_TRUE(isInstalledLevel(levels / ".." / "levels" / "new.json"));
  EXPECT_FALSE(isInstalledLevel("/tmp/1-plane.json"));
  EXPECT_FALSE(isInstalledLevel({}));
}

}  // namespace
}  // namespace anamorph
