#include "level/level_library.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/file.h"
#include "error_text.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// The levels of the source tree, wherever the test program lies and runs.
class LevelLibrary : public testing::Test {
 protected:
  void SetUp() override { setenv("ANAMORPH_RESOURCES", ANAMORPH_SOURCE_DIR, 1); }
  void TearDown() override { unsetenv("ANAMORPH_RESOURCES"); }
};

TEST_F(LevelLibrary, ListsTheInstalledLevelsByName) {
  const auto levels = listLevels();
  std::vector<std::string> names;
  for (const LevelEntry& entry : levels) {
    names.push_back(entry.name);
    EXPECT_EQ(entry.problem, "");
    EXPECT_FALSE(entry.title.empty()) << entry.name;
  }
  EXPECT_EQ(names, (std::vector<std::string>{"0-perspective", "1-plane", "2-cylinder", "3-sphere",
                                             "4-mistakes", "5-cone", "6-hollow", "7-free-form", "sandbox"}));
}

TEST_F(LevelLibrary, InstalledLevelsAreCompleteAndLoadWithoutWarnings) {
  for (const LevelEntry& entry : listLevels()) {
    const LoadedLevel loaded = loadLevel(entry.path);
    EXPECT_TRUE(loaded.warnings.empty()) << entry.name << ": " << loaded.warnings[0];
    EXPECT_FALSE(loaded.level.text->description.empty()) << entry.name;
    EXPECT_FALSE(loaded.level.lights.empty()) << entry.name;
  }
}

TEST_F(LevelLibrary, FindsALevelByNameNumberOrWord) {
  const fs::path plane = levelFolder() / "1-plane.json";
  for (const char* name : {"1-plane", "1", "plane"}) EXPECT_EQ(findLevel(name), plane) << name;
  EXPECT_EQ(findLevel("sphere"), levelFolder() / "3-sphere.json");
}

TEST_F(LevelLibrary, PathsComeBackAsTheyAre) {
  for (const char* path : {"mine.json", "folder/mine", "./1-plane", "/dev/null"})
    EXPECT_EQ(findLevel(path), path);
}

TEST_F(LevelLibrary, AFileGoesBeforeALevelOfTheSameName) {
  const fs::path before = fs::current_path();
  const fs::path folder = fs::path(testing::TempDir()) / ("library" + std::to_string(getpid()));
  fs::create_directory(folder);
  fs::current_path(folder);
  writeFile("sphere", "{}");
  fs::create_directory("plane");
  EXPECT_EQ(findLevel("sphere"), "sphere");
  EXPECT_EQ(findLevel("plane"), levelFolder() / "1-plane.json");
  fs::current_path(before);
  fs::remove_all(folder);
}

TEST_F(LevelLibrary, AnUnknownNameListsWhatThereIs) {
  EXPECT_EQ(errorOf([] { findLevel("torus"); }),
            "expected a file or one of the levels 0-perspective, 1-plane, 2-cylinder, 3-sphere, 4-mistakes, "
            "5-cone, 6-hollow, 7-free-form, sandbox, got \"torus\"");
  EXPECT_NE(errorOf([] { findLevel(""); }), "no error");
}

TEST(LevelFolder, ABrokenFileHidesNoOther) {
  const fs::path folder = fs::path(testing::TempDir()) / ("levels" + std::to_string(getpid()));
  fs::create_directory(folder);
  Level good;
  good.text = LevelText{"Good", "", "", {}};
  saveLevel(folder / "b.json", good);
  writeFile(folder / "a.json", "{");
  writeFile(folder / "notes.txt", "not a level");
  const auto levels = listLevels(folder);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].title, "");
  EXPECT_NE(levels[0].problem.find("a.json: line 1, column 2"), std::string::npos) << levels[0].problem;
  EXPECT_EQ(levels[1].title, "Good");
  EXPECT_EQ(levels[1].problem, "");
  fs::remove_all(folder);
  EXPECT_EQ(errorOf([&] { listLevels(folder); }),
            folder.string() + ": cannot list the levels: No such file or directory");
}

}  // namespace
}  // namespace anamorph
