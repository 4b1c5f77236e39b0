// Unsaved changes: kept in time, offered once, never lost.

#include "app/autosave.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "app/state_folder.h"
#include "base/error.h"
#include "cli/program.h"
#include "level/level_json.h"
#include "shapes.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

Level numbered(int number) {
  Level level;
  level.text.edit([&](LevelText& text) { text.title = "Number " + std::to_string(number); });
  level.sculpture.depthScale = 1 + number;
  return level;
}

class Autosaves : public ::testing::Test {
 protected:
  Autosaves() { session.startNew(numbered(0)); }

  std::size_t files() const {
    std::size_t count = 0;
    std::error_code none;
    for (fs::directory_iterator entry(folder, none), end; !none && entry != end; entry.increment(none))
      count += entry->path().extension() == ".json";
    return count;
  }
  bool waitForFiles(std::size_t count) const {
    for (int i = 0; i < 3000 && files() != count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return files() == count;
  }
  // A window that keeps `level` and dies.
  void die(const Level& level, const fs::path& path = {}) {
    const pid_t child = ::fork();
    if (child == 0) {
      Session other;
      path.empty() ? other.startNew(numbered(0)) : other.open(path);
      other.edit(level);
      Autosave autosave(folder);
      autosave.writeNow(other);
      ::kill(::getpid(), SIGKILL);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
  }

  TemporaryFolder temporary;
  fs::path folder = temporary / "state/anamorph";
  Session session;
};

TEST_F(Autosaves, WriteSoonAfterAChangeAndNotTooOften) {
  Autosave autosave(folder);
  EXPECT_EQ(autosave.update(session, 100), std::nullopt);
  EXPECT_EQ(autosave.secondsUntilDue(100), std::nullopt) << "nothing to lose";
  session.edit(numbered(1));
  autosave.update(session, 101);
  EXPECT_EQ(autosave.secondsUntilDue(101), Autosave::restSeconds);
  autosave.update(session, 103);
  EXPECT_EQ(files(), 0u);
  autosave.update(session, 104.1);
  EXPECT_TRUE(waitForFiles(1));
  EXPECT_EQ(autosave.secondsUntilDue(105), std::nullopt);
  session.edit(numbered(2));
  autosave.update(session, 106);
  EXPECT_NEAR(*autosave.secondsUntilDue(106), 4.1, 1e-9) << "six seconds after the last";
}

TEST_F(Autosaves, WriteEveryTwoMinutesOfADrag) {
  Autosave autosave(folder);
  session.change(numbered(1));
  autosave.update(session, 100);
  EXPECT_LE(*autosave.secondsUntilDue(100), Autosave::mostSeconds);
  for (int i = 0; i < 130; ++i) {
    session.change(numbered(2 + i % 50));
    autosave.update(session, 100 + i);
  }
  EXPECT_TRUE(waitForFiles(1));
}

TEST_F(Autosaves, LeaveNothingWhenSavedOrEnded) {
  {
    Autosave autosave(folder);
    session.edit(numbered(1));
    autosave.writeNow(session);
    EXPECT_EQ(files(), 1u);
    session.undo();
    autosave.update(session, 1);
    EXPECT_TRUE(waitForFiles(0)) << "as it is saved again";
    session.redo();
    autosave.writeNow(session);
    EXPECT_EQ(files(), 1u);
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Autosaves, OfAWindowThatLivesAreNobodyElses) {
  Autosave autosave(folder), second(folder);
  session.edit(numbered(1));
  autosave.writeNow(session);
  second.writeNow(session);
  EXPECT_EQ(files(), 2u) << "two windows, two files";
  const pid_t child = ::fork();
  if (child == 0) ::_exit(static_cast<int>(findRescued(folder).size()));
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST_F(Autosaves, OfAWindowThatDiedAreOfferedNewestFirst) {
  saveLevel(temporary / "mine.json", numbered(3));
  die(numbered(1));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  die(numbered(2), temporary / "mine.json");
  std::vector<Rescued> found = findRescued(folder);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].level, numbered(2));
  EXPECT_EQ(found[0].levelPath, temporary / "mine.json");
  EXPECT_EQ(found[0].entry.title, "Number 2");
  EXPECT_EQ(found[1].level, numbered(1));
  EXPECT_EQ(found[1].levelPath, "");
  EXPECT_EQ(findRescued(folder).size(), 0u) << "while they are offered here, nobody else offers them";
  found[0].remove();
  found.clear();
  EXPECT_EQ(findRescued(folder).size(), 1u) << "what was decided later";
}

TEST_F(Autosaves, ThatCannotBeReadAreLeftAlone) {
  die(numbered(1));
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") writeText(entry.path(), "{\"format\": \"anamorph-recovery\", ");
  }
  const auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].entry.problem, "");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Autosaves, WithATimeThatIsNoneAreLeftAlone) {
  fs::create_directories(folder);
  const std::string level = formatLevel(numbered(1));
  for (const char* time : {"1e300", "1e18", "-1e18", "-1"}) {
    writeText(folder / "recovery-1.json", R"({"format": "anamorph-recovery", "path": "", "time": )" +
                                              std::string(time) + R"(, "level": )" + level + "}");
    const auto found = findRescued(folder);
    ASSERT_EQ(found.size(), 1u) << time;
    EXPECT_NE(found[0].entry.problem.find("/time"), std::string::npos) << found[0].entry.problem;
  }
}

TEST_F(Autosaves, OfOlderProgramsWithTheSameNumberStay) {
  fs::create_directories(folder);
  const fs::path old = folder / ("recovery-" + std::to_string(::getpid()) + ".json");
  writeText(old, "precious");
  {
    Autosave autosave(folder);
    session.edit(numbered(1));
    autosave.writeNow(session);
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(readAll(old), "precious");
}

TEST_F(Autosaves, OnAFullDiskKeepTheLastOneAndSaySo) {
  Autosave autosave(folder);
  session.edit(numbered(1));
  autosave.writeNow(session);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{500, before.rlim_max};
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  ::setrlimit(RLIMIT_FSIZE, &small);
  session.edit(numbered(2));
  EXPECT_THROW(autosave.writeNow(session), Error);
  std::optional<std::string> told;
  session.edit(numbered(3));
  for (int i = 0; i < 3000 && !told; ++i) {
    told = autosave.update(session, 1000 + i);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  ::signal(SIGXFSZ, handler);
  ASSERT_TRUE(told);
  EXPECT_NE(told->find("File too large"), std::string::npos) << *told;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") {
      EXPECT_NE(readAll(entry.path()).find("Number 1"), std::string::npos);
    }
  }
}

TEST_F(Autosaves, OfALevelThatNoFileHoldsKeepTheOneBefore) {
  Autosave autosave(folder);
  session.edit(numbered(1));
  autosave.writeNow(session);
  Level broken = numbered(2);
  broken.optic.shape() = SphereMirror{{0, 0, 0}, 0};
  session.edit(broken);
  EXPECT_NO_THROW(autosave.writeNow(session));
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") {
      EXPECT_NE(readAll(entry.path()).find("Number 1"), std::string::npos);
    }
  }
}

TEST_F(Autosaves, OfLevelsThatWereLeftAreKeptUntilTheyAreOpenAgain) {
  std::map<fs::path, Level> left{{"/levels/a.json", numbered(1)}, {"/levels/b.json", numbered(2)}};
  {
    Autosave autosave(folder);
    EXPECT_EQ(autosave.keepLeft(left), std::nullopt);
    EXPECT_EQ(files(), 2u);
    session.edit(numbered(3));
    autosave.writeNow(session);
    EXPECT_EQ(files(), 3u);
    left.erase("/levels/a.json");
    left["/levels/b.json"] = numbered(4);
    EXPECT_EQ(autosave.keepLeft(left), std::nullopt);
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(files(), 0u) << "it ended as it should";
  const pid_t child = ::fork();
  if (child == 0) {
    Autosave autosave(folder);
    autosave.keepLeft(left);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].levelPath, "/levels/b.json");
  EXPECT_EQ(found[0].level, numbered(4));
}

TEST_F(Autosaves, RememberWhenTheLevelsFileWasWritten) {
  const fs::path path = temporary / "mine.json";
  saveLevel(path, numbered(0));
  session.open(path);
  const auto known = session.fileTime();
  ASSERT_TRUE(known);
  die(numbered(1), path);
  fs::last_write_time(path, *known + std::chrono::seconds(9));  // another program
  auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].fileTime, known);
  session.recover(path, readLevelFile(path), found[0].level, found[0].fileTime);
  EXPECT_TRUE(session.isFileChanged());
}

TEST_F(Autosaves, WhereTheWorkingFolderIsGoneGoOn) {
  saveLevel(temporary / "mine.json", numbered(0));
  const fs::path before = fs::current_path();
  fs::create_directory(temporary / "here");
  fs::current_path(temporary / "here");
  session.open("../mine.json");
  session.edit(numbered(1));
  fs::remove(temporary / "here");
  Autosave autosave(folder);
  EXPECT_NO_THROW(autosave.writeNow(session));
  fs::current_path(before);
  EXPECT_EQ(files(), 1u);
}

TEST_F(Autosaves, WhereNothingCanBeWrittenSaySo) {
  writeText(temporary / "state", "a file in the folder's place");
  Autosave autosave(folder);
  session.edit(numbered(1));
  EXPECT_THROW(autosave.writeNow(session), Error);
  autosave.update(session, 100);
  const auto told = autosave.update(session, 200);
  ASSERT_TRUE(told);
  EXPECT_NE(told->find("state"), std::string::npos);
}

TEST(StateFolder, IsTheOneOfTheStandard) {
  ::setenv("XDG_STATE_HOME", "/x/state", 1);
  EXPECT_EQ(stateFolder(), "/x/state/anamorph");
  ::setenv("XDG_STATE_HOME", "relative", 1);
  const char* home = std::getenv("HOME");
  EXPECT_EQ(stateFolder(), fs::path(home && *home ? home : "/") / ".local/state/anamorph");
  ::unsetenv("XDG_STATE_HOME");
}

TEST(RecentFiles, AreKeptTogetherWithThoseOfOtherWindows) {
  const TemporaryFolder folder;
  UiState ui, other, third;
  ui.recentLevels = {"/a/1.json", "/a/2.json"};
  ui.browser.recentFolders = {"/a"};
  saveRecent(folder / "state", ui);
  other.recentLevels = {"/b/3.json", "/a/2.json"};
  saveRecent(folder / "state", other);
  loadRecent(folder / "state", third);
  EXPECT_EQ(third.recentLevels, (std::vector<fs::path>{"/b/3.json", "/a/2.json", "/a/1.json"}));
  EXPECT_EQ(third.browser.recentFolders, (std::vector<fs::path>{"/a"}));
  writeText(folder / "state/recent.json", "{\"levels\": [3, \"relative\", null, {}], \"folders\": 7");
  UiState fourth;
  EXPECT_NO_THROW(loadRecent(folder / "state", fourth));
  EXPECT_TRUE(fourth.recentLevels.empty());
}

}  // namespace
}  // namespace anamorph
