// What is found after a crash: offered once, never lost, never in place of something newer.

#include "app/recovery_files.h"

#include <chrono>
#include <string>

#include <gtest/gtest.h>

#include "edit/session.h"
#include "level/level_json.h"
#include "recovery_fixture.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

class RecoveryFiles : public RecoveryTest {
 protected:
  RecoveryFiles() { saveLevel(mine, numbered(0)); }

  // As by another program, or another window; its time is another one, later or not.
  void write(const Level& level, std::chrono::seconds later) const {
    const auto time = fs::last_write_time(mine);
    saveLevel(mine, level);
    fs::last_write_time(mine, time + later);
  }

  std::string mine = temporary / "mine.json";
};

TEST_F(RecoveryFiles, OfWindowsThatDiedAreOfferedNewestFirst) {
  die(numbered(1));
  die(numbered(2), mine);
  std::vector<Rescued> found = findRescued(folder);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].level, numbered(2));
  EXPECT_EQ(found[0].path, mine);
  EXPECT_EQ(found[0].entry.title, "Number 2");
  EXPECT_FALSE(found[0].entry.fileIsNewer);
  EXPECT_EQ(found[1].level, numbered(1));
  EXPECT_EQ(found[1].path, "");
  EXPECT_EQ(findRescued(folder).size(), 0u) << "while they are offered here, nobody else offers them";
  found[0].remove();
  found.clear();
  EXPECT_EQ(findRescued(folder).size(), 1u) << "what was decided later";
}

TEST_F(RecoveryFiles, AreInOrderThoughTheClockWentBack) {
  for (int number = 1; number <= 3; ++number) {
    die(numbered(number));
    for (const fs::path& file : kept()) {
      fs::last_write_time(file, fs::last_write_time(file) + std::chrono::hours(1));  // it was later then
    }
  }
  const auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 3u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(found[static_cast<std::size_t>(i)].level, numbered(3 - i));
}

TEST_F(RecoveryFiles, ThatCannotBeReadAreLeftAlone) {
  die(numbered(1));
  writeText(kept().at(0), "{\"format\": \"anamorph-recovery\", ");
  const auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].entry.problem, "");
  EXPECT_EQ(files(), 1u);
}

TEST_F(RecoveryFiles, WithATimeThatIsNoneAreLeftAlone) {
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

// It was killed between saving and removing.
TEST_F(RecoveryFiles, OfWhatWasSavedAreNotOffered) {
  die(numbered(1), mine);
  write(numbered(1), std::chrono::seconds(1));
  EXPECT_EQ(findRescued(folder).size(), 0u);
  EXPECT_TRUE(fs::is_empty(folder)) << "and they are cleared away";
}

// It was killed after saving, before what came next was kept. The clock may have gone back meanwhile.
TEST_F(RecoveryFiles, OlderThanTheFileSaySoAndAreNoOtherProgram) {
  for (const auto later : {std::chrono::seconds(1), std::chrono::seconds(-3600)}) {
    die(numbered(1), mine);
    write(numbered(2), later);
    auto found = findRescued(folder);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].entry.fileIsNewer);
    Session session;
    session.recover(mine, readLevelFile(mine), found[0].level, found[0].fileTime);
    EXPECT_EQ(session.level(), numbered(1));
    EXPECT_FALSE(isWrittenElsewhere(session.path(), session.fileTime())) << "who restores it has been told";
    write(numbered(3), std::chrono::seconds(5));
    EXPECT_TRUE(isWrittenElsewhere(session.path(), session.fileTime())) << "this is news";
    found[0].remove();
  }
}

// Another program wrote the file while the window that died still went on.
TEST_F(RecoveryFiles, NewerThanAFileThatAnotherProgramWroteRememberIt) {
  die(numbered(1), mine, [&](Session&) { write(numbered(2), std::chrono::seconds(5)); });
  const auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].entry.fileIsNewer);
  Session session;
  session.recover(mine, readLevelFile(mine), found[0].level, found[0].fileTime);
  EXPECT_TRUE(isWrittenElsewhere(session.path(), session.fileTime()));
}

TEST_F(RecoveryFiles, OfAFileThatIsGoneOrBrokenAreOffered) {
  die(numbered(1), mine);
  fs::remove(mine);
  EXPECT_EQ(findRescued(folder).size(), 1u);
  writeText(mine, "{");
  EXPECT_EQ(findRescued(folder).size(), 1u);
}

}  // namespace
}  // namespace anamorph
