// Unsaved changes: kept in time, without a frame that waits; what cannot be kept is said.

#include "app/autosave.h"

#include <sys/resource.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <map>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "app/state_folder.h"
#include "app/unsaved_bytes.h"
#include "level/level_json.h"
#include "long_lesson.h"
#include "recovery_fixture.h"
#include "save_session.h"
#include "shapes.h"
#include "small_disk.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

class Autosaves : public RecoveryTest {
 protected:
  Autosaves() { session.startNew(numbered(0)); }

  // A frame, and all that it lets write.
  std::optional<std::string> update(Autosave& autosave, double now) {
    const auto news = autosave.update(session, left, now);
    EXPECT_TRUE(autosave.finish(20));
    return news;
  }
  // As long as it takes to be kept.
  void keep(Autosave& autosave) {
    for (int i = 0; i < 3; ++i) update(autosave, clock += 10);
  }

  Session session;
  Autosave::LeftLevels left;
  double clock = 1000;  // a clock that never goes back, as the window's
};

TEST_F(Autosaves, WriteSoonAfterAChangeAndNotTooOften) {
  Autosave autosave(folder);
  EXPECT_EQ(update(autosave, 100), std::nullopt);
  EXPECT_EQ(autosave.secondsUntilDue(100), std::nullopt) << "nothing to lose";
  session.edit(numbered(1));
  update(autosave, 101);
  EXPECT_EQ(files(), 0u);
  EXPECT_EQ(autosave.secondsUntilDue(101), Autosave::gatherSeconds);
  update(autosave, 102.1);
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(autosave.secondsUntilDue(103), std::nullopt);
  session.edit(numbered(2));
  update(autosave, 103);
  EXPECT_NEAR(*autosave.secondsUntilDue(103), 3.1, 1e-9) << "four seconds after the last";
  session.undo();
  update(autosave, 104);
  EXPECT_EQ(autosave.secondsUntilDue(104), std::nullopt) << "that is kept";
}

// Drags and edits in every rhythm: at no time is there a change of ten seconds ago that is not kept.
TEST_F(Autosaves, NeverLoseMoreThanTenSeconds) {
  for (const double interval : {0.05, 0.5, 2.0, 2.9, 3.1, 5.9, 9.0}) {
    for (const bool drags : {false, true}) {
      SCOPED_TRACE((drags ? "a drag, seconds: " : "edits, seconds: ") + std::to_string(interval));
      session.startNew(numbered(0));
      Autosave autosave(folder);
      std::map<std::string, double> times;  // when each title came
      double next = 100;
      int number = 0;
      for (double now = 100; now < 160; now += 0.05) {
        if (now >= next) {
          const Level level = numbered(++number);
          drags ? session.change(level) : session.edit(level);
          times[level.text->title] = now;
          next += interval;
        }
        update(autosave, now);
        if (now < 110) continue;
        ASSERT_EQ(files(), 1u) << now;
        // What is kept was the level at some time in the last ten seconds.
        const std::string kept = keptTitle();
        const int successor = std::stoi(kept.substr(kept.rfind(' '))) + 1;
        if (successor > number) continue;
        ASSERT_GT(times.at("Number " + std::to_string(successor)), now - 10) << now;
      }
    }
  }
}

// A level with a long lesson takes many times as long to be written as text as a frame may take.
TEST_F(Autosaves, LeaveTheTextAndTheDiskToAnotherThread) {
  const auto threadSeconds = [] {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
  };
  Level level = numbered(1);
  level.text.edit([](LevelText& text) { text.lesson = longLesson(); });
  double start = threadSeconds();
  formatLevel(level);
  const double formatting = threadSeconds() - start;
  Autosave autosave(folder);
  session.edit(level);
  start = threadSeconds();
  rusage before{}, after{};
  ::getrusage(RUSAGE_THREAD, &before);
  for (int i = 0; i < 3; ++i) autosave.update(session, left, clock += 10);
  ::getrusage(RUSAGE_THREAD, &after);
  EXPECT_LT(threadSeconds() - start, formatting / 4);
  EXPECT_EQ(after.ru_oublock, before.ru_oublock) << "blocks written to a disk";
  ASSERT_TRUE(autosave.finish(20));
  EXPECT_EQ(files(), 1u);
}

TEST_F(Autosaves, LeaveNothingWhenSavedOrEnded) {
  {
    Autosave autosave(folder);
    session.edit(numbered(1));
    keep(autosave);
    EXPECT_EQ(files(), 1u);
    session.undo();
    keep(autosave);
    EXPECT_EQ(files(), 0u) << "as it is saved again";
    session.redo();
    keep(autosave);
    EXPECT_EQ(files(), 1u);
  }
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST_F(Autosaves, AreThereAsBytesForWhoeverHandlesACrash) {
  {
    Autosave autosave(folder);
    session.edit(numbered(1));
    keep(autosave);
    const std::unique_ptr<const UnsavedBytes> taken(takeUnsaved());
    ASSERT_TRUE(taken);
    EXPECT_EQ(taken->file, kept().at(0));
    EXPECT_NE(taken->bytes.find("Number 1"), std::string::npos) << taken->bytes;
    EXPECT_EQ(takeUnsaved(), nullptr) << "they are whose who took them";
    session.edit(numbered(2));
    keep(autosave);
    session.reset();
    keep(autosave);
    EXPECT_EQ(takeUnsaved(), nullptr) << "it is saved";
    session.undo();
    keep(autosave);
  }
  EXPECT_EQ(takeUnsaved(), nullptr) << "it ended as it should";
}

// Long before anything is due on disk, and never an older state after a newer one.
TEST_F(Autosaves, AreThereAsBytesAtOnce) {
  Autosave autosave(folder);
  for (int number = 1; number <= 20; ++number) {
    session.edit(numbered(number));
    update(autosave, clock += 0.01);
    const std::unique_ptr<const UnsavedBytes> taken(takeUnsaved());
    ASSERT_TRUE(taken) << number;
    EXPECT_NE(taken->bytes.find("Number " + std::to_string(number) + "\""), std::string::npos)
        << taken->bytes;
  }
  EXPECT_EQ(files(), 0u);
  EXPECT_EQ(update(autosave, clock + 0.01), std::nullopt);
  EXPECT_EQ(takeUnsaved(), nullptr) << "nothing has changed";
}

TEST_F(Autosaves, OfAWindowThatLivesAreNobodyElses) {
  Autosave autosave(folder), second(folder);
  session.edit(numbered(1));
  keep(autosave);
  keep(second);
  EXPECT_EQ(files(), 2u) << "two windows, two files";
  EXPECT_EQ(offeredElsewhere(), 0);
}

TEST_F(Autosaves, InAFolderThatHasVanishedMakeItAgain) {
  Autosave autosave(folder);
  session.edit(numbered(1));
  keep(autosave);
  fs::remove_all(folder);
  session.edit(numbered(2));
  keep(autosave);
  EXPECT_EQ(files(), 1u);
  EXPECT_EQ(keptTitle(), "Number 2");
  EXPECT_EQ(offeredElsewhere(), 0) << "and have it for themselves";
}

TEST_F(Autosaves, OfOlderProgramsWithTheSameNumberStay) {
  fs::create_directories(folder);
  const fs::path old = folder / ("recovery-" + std::to_string(::getpid()) + ".json");
  writeText(old, "precious");
  {
    Autosave autosave(folder);
    session.edit(numbered(1));
    keep(autosave);
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(readAll(old), "precious");
}

TEST_F(Autosaves, OnAFullDiskKeepTheLastOneAndSaySoOnce) {
  std::atomic<int> woken = 0;
  Autosave autosave(folder, [&woken] { ++woken; });
  session.edit(numbered(1));
  keep(autosave);
  std::vector<std::string> told;
  {
    const SmallDisk full(500);
    session.edit(numbered(2));
    woken = 0;
    for (int i = 0; i < 20; ++i) {
      if (const auto news = update(autosave, clock += 1)) told.push_back(*news);
    }
    EXPECT_GT(woken, 1) << "so that the window says it at once";
  }
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].find("File too large"), std::string::npos) << told[0];
  EXPECT_EQ(keptTitle(), "Number 1");
  told.clear();
  for (int i = 0; i < 10; ++i) {
    if (const auto news = update(autosave, clock += 1)) told.push_back(*news);
  }
  EXPECT_EQ(told, std::vector<std::string>{"Unsaved changes are kept again."});
  EXPECT_EQ(keptTitle(), "Number 2");
}

TEST_F(Autosaves, OfALevelThatNoFileHoldsKeepTheOneBefore) {
  Autosave autosave(folder);
  session.edit(numbered(1));
  keep(autosave);
  Level broken = numbered(2);
  broken.optic.shape() = SphereMirror{{0, 0, 0}, 0};
  session.edit(broken);
  keep(autosave);
  EXPECT_EQ(keptTitle(), "Number 1");
}

TEST_F(Autosaves, OfLevelsThatWereLeftAreKeptUntilTheyAreOpenAgain) {
  left = {{"/levels/a.json", numbered(1)}, {"/levels/b.json", numbered(2)}};
  {
    Autosave autosave(folder);
    keep(autosave);
    EXPECT_EQ(files(), 2u);
    session.edit(numbered(3));
    keep(autosave);
    EXPECT_EQ(files(), 3u);
    left.erase("/levels/a.json");
    left["/levels/b.json"] = numbered(4);
    keep(autosave);
    EXPECT_EQ(files(), 2u);
  }
  EXPECT_EQ(files(), 0u) << "it ended as it should";
  dieWith([&] {
    Autosave& autosave = *new Autosave(folder);  // its destructor would end it as it should
    session.reset();
    keep(autosave);
  });
  const auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].path, "/levels/b.json");
  EXPECT_EQ(found[0].level, numbered(4));
}

// From the open one to one that was left, and back: at no time is it nowhere.
TEST_F(Autosaves, OfALevelThatIsLeftGoFromOneFileToTheOther) {
  Autosave autosave(folder);
  session.edit(numbered(1));
  keep(autosave);
  session.startNew(numbered(0));
  left = {{"/levels/a.json", numbered(1)}};
  for (double now = clock; now < clock + 5; now += 0.1) {
    update(autosave, now);
    ASSERT_GE(files(), 1u);
  }
  EXPECT_EQ(files(), 1u);
  session.edit(numbered(1));
  left.clear();
  for (double now = clock + 5; now < clock + 10; now += 0.1) {
    update(autosave, now);
    ASSERT_GE(files(), 1u);
  }
  EXPECT_EQ(files(), 1u);
}

TEST_F(Autosaves, OfWhatWasRestoredGoOnInTheSameFile) {
  die(numbered(1));
  auto found = findRescued(folder);
  ASSERT_EQ(found.size(), 1u);
  Autosave autosave(folder);
  session.recover(found[0].path, std::nullopt, found[0].level, found[0].fileTime);
  autosave.adopt(std::move(found[0]));
  for (int i = 0; i < 10; ++i) {
    update(autosave, clock += 1);
    ASSERT_EQ(files(), 1u);
  }
  EXPECT_EQ(offeredElsewhere(), 0);
  testing::saveTo(session, temporary / "saved.json");
  keep(autosave);
  EXPECT_EQ(files(), 0u);
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
  keep(autosave);
  fs::current_path(before);
  EXPECT_EQ(files(), 1u);
}

TEST_F(Autosaves, WhereNothingCanBeWrittenSaySoOnce) {
  writeText(temporary / "state", "a file in the folder's place");
  Autosave autosave(folder);
  session.edit(numbered(1));
  int told = 0;
  for (int i = 0; i < 60; ++i) {
    const auto news = update(autosave, clock += 1);
    if (!news) continue;
    ++told;
    EXPECT_NE(news->find("state"), std::string::npos) << *news;
  }
  EXPECT_EQ(told, 1);
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
  saveRecent(folder / "state", {{"/a/1.json", "/a/2.json"}, {"/a"}});
  saveRecent(folder / "state", {{"/b/3.json", "/a/2.json"}, {}});
  const RecentFiles all{{"/b/3.json", "/a/2.json", "/a/1.json"}, {"/a"}};
  EXPECT_EQ(loadRecent(folder / "state"), all);
  writeText(folder / "state/recent.json", "{\"levels\": [3, \"relative\", null, {}], \"folders\": 7");
  EXPECT_EQ(loadRecent(folder / "state"), RecentFiles());
}

}  // namespace
}  // namespace anamorph
