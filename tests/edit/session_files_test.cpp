// Saving: what is saved is found again, whatever happens meanwhile; the history goes on; what could not be
// saved is not lost.

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/program.h"
#include "edit/session.h"
#include "error_text.h"
#include "level/level_json.h"
#include "level/random_level.h"
#include "save_session.h"
#include "shapes.h"
#include "small_disk.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

Level numbered(int number) {
  Level level;
  level.sculpture.depthScale = 1 + number;
  return level;
}

TEST(SessionFiles, RandomLevelsAreTheSameAfterSavingAndOpening) {
  const TemporaryFolder folder;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Session session;
    session.startNew(numbered(0));
    Level level = RandomLevel(seed).make();
    if (auto* file = std::get_if<FileShape>(&level.original.shape)) file->path = "/somewhere/" + file->path;
    if (level.optic.shape().as<MeshMirror>()) continue;  // its file is read, and is not there
    if (level.sculpture.frozen && level.sculpture.frozen->optic.shape().as<MeshMirror>()) continue;
    session.edit(level);
    testing::saveTo(session, folder / "level.json");
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
  testing::saveTo(session, folder / "a.json");
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
  testing::saveTo(session, folder / "a.json");
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
  testing::saveTo(session, folder / "level.json");
  EXPECT_FALSE(session.isThesisScene());
  EXPECT_FALSE(loadLevel(folder / "level.json").isThesisScene);
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
  EXPECT_TRUE(isWrittenElsewhere(session.path(), session.fileTime()))
      << "a file that cannot be read may be somebody's work";
  session.recover(folder / "gone.json", std::nullopt, numbered(5));
  EXPECT_FALSE(isWrittenElsewhere(session.path(), session.fileTime()));
  saveLevel(folder / "a.json", numbered(1));
  const auto written = fs::last_write_time(folder / "a.json");
  session.recover(folder / "a.json", readLevelFile(folder / "a.json"), numbered(5), written);
  EXPECT_FALSE(isWrittenElsewhere(session.path(), session.fileTime()));
  session.recover(folder / "a.json", readLevelFile(folder / "a.json"), numbered(5),
                  written - std::chrono::seconds(1));
  EXPECT_TRUE(isWrittenElsewhere(session.path(), session.fileTime()))
      << "another program wrote it, before or after the rescue";
  EXPECT_EQ(session.fileTime(), written - std::chrono::seconds(1)) << "also for the next rescue";
  testing::saveTo(session, folder / "a.json");
  EXPECT_FALSE(isWrittenElsewhere(session.path(), session.fileTime()));
}

// What a full disk, a folder without permission, a folder that is gone have in common.
void expectNothingLost(Session& session, const std::string& folder, const std::string& target,
                       const std::string& reason) {
  const Level level = session.level();
  const fs::path path = session.path();
  const bool canRedo = session.canRedo();
  const std::string message = errorOf([&] { testing::saveTo(session, target); });
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
  testing::saveTo(session, folder / "a.json");
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

}  // namespace
}  // namespace anamorph
