// Saving: what is saved is found again, whatever happens meanwhile; the history goes on; what could not be
// saved is not lost.

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/program.h"
#include "edit/level_files.h"
#include "edit/session.h"
#include "error_text.h"
#include "level/level_json.h"
#include "level/random_level.h"
#include "pipeline/original.h"
#include "shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

const fs::path levels = ANAMORPH_LEVELS;
const fs::path meshes = fs::path(ANAMORPH_TEST_DATA) / "meshes";

Level numbered(int number) {
  Level level;
  level.sculpture.depthScale = 1 + number;
  return level;
}

// Files can grow to so many bytes only, as on a disk that is full.
class SmallDisk {
 public:
  explicit SmallDisk(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(SessionFiles, RandomLevelsAreTheSameAfterSavingAndOpening) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Session session;
    session.startNew(numbered(0));
    Level level = RandomLevel(seed).make();
    if (auto* file = std::get_if<FileShape>(&level.original.shape)) file->path = "/somewhere/" + file->path;
    session.edit(level);
    session.saveTo(folder / "level.json");
    EXPECT_FALSE(session.modified());
    Session other;
    other.open(folder / "level.json");
    EXPECT_EQ(other.level(), session.level());
    EXPECT_EQ(other.level().optic, level.optic);
    EXPECT_EQ(other.level().text->unknownKeys, level.text->unknownKeys);
    EXPECT_EQ(formatLevel(other.level()), readAll(folder / "level.json"));
  }
}

TEST(SessionFiles, ModifiedMeansDifferentFromTheFile) {
  const TemporaryFolder folder;
  Session session;
  session.startNew(numbered(0));
  EXPECT_FALSE(session.modified());
  session.edit(numbered(1));
  EXPECT_TRUE(session.modified());
  session.saveTo(folder / "a.json");
  EXPECT_FALSE(session.modified());
  session.edit(numbered(2));
  session.undo();
  EXPECT_FALSE(session.modified()) << "back at what is saved";
  session.undo();
  EXPECT_EQ(session.level(), numbered(0)) << "the history goes through the saving";
  EXPECT_TRUE(session.modified());
  session.redo();
  EXPECT_FALSE(session.modified());
  session.edit(numbered(3));
  session.reset();
  EXPECT_EQ(session.level(), numbered(1));
}

TEST(SessionFiles, SavingInADragFinishesItAsOneStep) {
  const TemporaryFolder folder;
  Session session;
  session.startNew(numbered(0));
  session.change(numbered(1));
  session.change(numbered(2));
  session.saveTo(folder / "a.json");
  EXPECT_FALSE(session.changing());
  EXPECT_EQ(loadLevel(folder / "a.json").level, numbered(2));
  session.undo();
  EXPECT_EQ(session.level(), numbered(0));
}

TEST(SessionFiles, ASavedSceneOfTheThesisIsALevel) {
  const TemporaryFolder folder;
  Session session;
  session.open(fs::path(ANAMORPH_TEST_DATA) / "scenes" / "thesis-sphere.json");
  EXPECT_TRUE(session.isThesisScene());
  session.saveTo(folder / "level.json");
  EXPECT_FALSE(session.isThesisScene());
  EXPECT_FALSE(loadLevel(folder / "level.json").isThesisScene);
}

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
    return loadOriginal(session.level().original.shape, session.path())->positions.size() == 8;
  }

  TemporaryFolder folder;
  Session session;
};

TEST_F(MovedLevel, FindsItsMeshFromAnotherFolder) {
  Level changed = session.level();
  changed.sculpture.depthScale = 2;
  session.edit(changed);
  session.saveTo(folder / "b/level.json");
  EXPECT_TRUE(fs::path(meshPath()).is_absolute());
  EXPECT_TRUE(findsMesh());
  session.undo();
  EXPECT_TRUE(findsMesh()) << "the steps before the saving are of the new folder, too";
  session.redo();
  session.saveTo(folder / "a/other.json");
  EXPECT_EQ(meshPath(), "meshes/cube.obj") << "relative again where it lies below the level";
  EXPECT_TRUE(findsMesh());
  EXPECT_FALSE(session.modified());
}

TEST_F(MovedLevel, KeepsItsWordsInTheSameFolder) {
  Level level = session.level();
  level.original.shape = FileShape{"../a/meshes/cube.obj"};
  session.edit(level);
  session.saveTo(folder / "a/again.json");
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
  session.saveTo(folder / "b/level.json");
  EXPECT_TRUE(findsMesh()) << meshPath();
}

TEST_F(MovedLevel, AsTextIsFoundFromEverywhere) {
  const std::string text = levelAsText(session.level(), session.path());
  EXPECT_EQ(text.find('\n'), std::string::npos);
  Session other;
  other.startNew(levelFromText(text, {}));
  EXPECT_EQ(loadOriginal(other.level().original.shape, {})->positions.size(), 8u);
  EXPECT_EQ(levelFromText(text, session.path()), session.level());
}

TEST(LevelText, BadTextsAreClearMessages) {
  for (const char* text : {"", " \n", "Hello", "{", "[1]", "{\"format\": \"anamorph-level\"}",
                           "{\"Eye\": [0, 0, 0], \"Objects\": []}"}) {
    const std::string message = errorOf([&] { levelFromText(text, {}); });
    EXPECT_EQ(message.find("the text on the clipboard"), 0u) << text << ": " << message;
  }
}

TEST(LevelText, RandomLevelsComeBack) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Level level = RandomLevel(seed).make();
    if (auto* file = std::get_if<FileShape>(&level.original.shape)) file->path = "/x" + std::to_string(seed);
    EXPECT_EQ(levelFromText(levelAsText(level, "/somewhere/level.json"), "/else/where.json"), level);
  }
}

TEST(InstalledLevels, AreKnownHoweverTheirPathIsWritten) {
  EXPECT_TRUE(isInstalledLevel(levels / "1-plane.json"));
  EXPECT_TRUE(isInstalledLevel(levels / ".." / "levels" / "new.json"));
  EXPECT_FALSE(isInstalledLevel("/tmp/1-plane.json"));
  EXPECT_FALSE(isInstalledLevel({}));
}

TEST(Recovery, IsOneStepFromWhatIsSaved) {
  const TemporaryFolder folder;
  saveLevel(folder / "a.json", numbered(1));
  Session session;
  session.recover(folder / "a.json", readLevelFile(folder / "a.json"), numbered(5));
  EXPECT_EQ(session.level(), numbered(5));
  EXPECT_TRUE(session.modified());
  session.undo();
  EXPECT_EQ(session.level(), numbered(1));
  EXPECT_FALSE(session.modified());
}

TEST(Recovery, NeedsNoFile) {
  const TemporaryFolder folder;
  for (const fs::path& path : {fs::path(), fs::path(folder / "gone.json")}) {
    Session session;
    session.recover(path, std::nullopt, numbered(5));
    EXPECT_EQ(session.level(), numbered(5));
    EXPECT_EQ(session.path(), path);
    EXPECT_TRUE(session.modified());
  }
}

TEST(Recovery, IsNotSavedOverWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  writeText(folder / "broken.json", "{");
  Session session;
  session.recover(folder / "broken.json", std::nullopt, numbered(5));
  EXPECT_TRUE(session.isFileChanged()) << "a file that cannot be read may be somebody's work";
  session.recover(folder / "gone.json", std::nullopt, numbered(5));
  EXPECT_FALSE(session.isFileChanged());
  saveLevel(folder / "a.json", numbered(1));
  const auto written = fs::last_write_time(folder / "a.json");
  session.recover(folder / "a.json", readLevelFile(folder / "a.json"), numbered(5), written);
  EXPECT_FALSE(session.isFileChanged());
  session.recover(folder / "a.json", readLevelFile(folder / "a.json"), numbered(5),
                  written - std::chrono::seconds(1));
  EXPECT_TRUE(session.isFileChanged()) << "another program wrote it, before or after the rescue";
  EXPECT_EQ(session.fileTime(), written - std::chrono::seconds(1)) << "also for the next rescue";
  session.saveTo(folder / "a.json");
  EXPECT_FALSE(session.isFileChanged());
}

// What a full disk, a folder without permission, a folder that is gone have in common.
void expectNothingLost(Session& session, const std::string& folder, const std::string& target,
                       const std::string& reason) {
  const Level level = session.level();
  const fs::path path = session.path();
  const bool canRedo = session.canRedo();
  const std::string message = errorOf([&] { session.saveTo(target); });
  EXPECT_NE(message.find(reason), std::string::npos) << message;
  EXPECT_NE(message.find(target), std::string::npos) << message;
  EXPECT_EQ(session.level(), level);
  EXPECT_EQ(session.path(), path);
  EXPECT_TRUE(session.modified());
  EXPECT_TRUE(session.canUndo());
  EXPECT_EQ(session.canRedo(), canRedo);
  for (const auto& entry : fs::directory_iterator(folder)) {
    EXPECT_NE(entry.path().filename().string().rfind(".anamorph-", 0), 0u) << "left behind: " << entry.path();
  }
}

TEST(FailedSave, OnAFullDiskKeepsFileAndLevel) {
  const TemporaryFolder folder;
  saveLevel(folder / "a.json", numbered(1));
  const std::string before = readAll(folder / "a.json");
  Session session;
  session.open(folder / "a.json");
  session.edit(numbered(2));
  {
    const SmallDisk disk(700);
    expectNothingLost(session, folder / "", folder / "a.json", "File too large");
  }
  EXPECT_EQ(readAll(folder / "a.json"), before);
  session.saveTo(folder / "a.json");
  EXPECT_FALSE(session.modified()) << "once there is room again";
}

TEST(FailedSave, ElsewhereKeepsThePath) {
  const TemporaryFolder folder;
  saveLevel(folder / "a.json", numbered(1));
  Session session;
  session.open(folder / "a.json");
  session.edit(numbered(2));
  expectNothingLost(session, folder / "", folder / "no/such/folder.json", "No such file");
  expectNothingLost(session, folder / "", folder / "", "");
}

TEST(FailedSave, OfALevelThatCouldNotBeOpenedSaysWhy) {
  const TemporaryFolder folder;
  Session session;
  session.startNew(numbered(0));
  Level broken;
  broken.optic.shape() = SphereMirror{{0, 0, 0}, 0};
  session.edit(broken);
  expectNothingLost(session, folder / "", folder / "a.json", "radius");
  EXPECT_FALSE(fs::exists(folder / "a.json"));
}

// A child saves two levels in turn, over and over, and is killed at any moment.
TEST(KilledSave, LeavesOneOfTheCompleteVersions) {
  const TemporaryFolder folder;
  const std::string path = folder / "level.json";
  Level versions[2] = {numbered(1), numbered(2)};
  versions[1].text.edit(
      [](LevelText& text) { text.description = std::string(200000, 'x'); });  // more than one write
  saveLevel(path, versions[0]);
  int seen[2] = {0, 0};
  for (int round = 0; round < 60; ++round) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      for (int i = round;; ++i) saveLevel(path, versions[i % 2]);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500 + (round * 7919) % 15000));
    ::kill(child, SIGKILL);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it was killed, it did not fail";
    const Level now = loadLevel(path).level;
    ASSERT_TRUE(now == versions[0] || now == versions[1]) << "round " << round;
    ++seen[now == versions[1]];
  }
  EXPECT_GT(seen[0] + seen[1], 0);
}

TEST(KilledSave, WhatItLeavesIsClearedAwayLater) {
  const TemporaryFolder folder;
  const auto age = [](const std::string& file, std::chrono::minutes minutes) {
    fs::last_write_time(file, fs::file_time_type::clock::now() - minutes);
  };
  for (const char* name : {".anamorph-aB3xYz", ".anamorph-Fresh1", "anamorph-123456"}) {
    writeText(folder / name, "{\"format\": ");
    age(folder / name, std::chrono::minutes(20));
  }
  age(folder / ".anamorph-Fresh1", std::chrono::minutes(1));
  Session session;
  session.startNew(numbered(0));
  session.saveTo(folder / "level.json");
  EXPECT_FALSE(fs::exists(folder / ".anamorph-aB3xYz"));
  EXPECT_TRUE(fs::exists(folder / ".anamorph-Fresh1")) << "somebody may still be writing it";
  EXPECT_TRUE(fs::exists(folder / "anamorph-123456"));
}

}  // namespace
}  // namespace anamorph
