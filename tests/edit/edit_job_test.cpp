#include "edit/edit_job.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/program.h"
#include "save_session.h"

namespace anamorph {
namespace {

using testing::TemporaryFolder;

Level numbered(int number) {
  Level level;
  level.sculpture.depthScale = 1 + number;
  return level;
}

std::string waitFor(EditJob& job, Session& session) {
  for (int i = 0; i < 2000; ++i) {
    if (auto message = job.update(session)) return *message;
    if (!job.busy()) return "";
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return "it never ends";
}

class EditJobs : public ::testing::Test {
 protected:
  EditJobs() { session.startNew(numbered(0)); }
  Session session;
  EditJob job;
};

TEST_F(EditJobs, BringTheirLevelAsOneStep) {
  job.start(session, "Work", [](const Level& level, const Progress&) {
    Level result = level;
    result.sculpture.depthScale = 3;
    return EditResult{result, "done"};
  });
  EXPECT_TRUE(job.busy());
  EXPECT_EQ(waitFor(job, session), "done");
  EXPECT_FALSE(job.busy());
  EXPECT_EQ(session.level().sculpture.depthScale, 3);
  session.undo();
  EXPECT_EQ(session.level(), numbered(0));
  EXPECT_FALSE(session.canUndo());
}

TEST_F(EditJobs, BringTheLevelBetweenAsAStepOfItsOwn) {
  job.start(session, "Work", [](const Level&, const Progress&) {
    return EditResult{numbered(2), "done", numbered(1)};
  });
  EXPECT_EQ(waitFor(job, session), "done");
  for (const int number : {2, 1, 0}) {
    EXPECT_EQ(session.level(), numbered(number));
    session.undo();
  }
  EXPECT_FALSE(session.canUndo());
}

TEST_F(EditJobs, ComeTooLateAfterAnotherChange) {
  job.start(session, "Work", [](const Level&, const Progress&) { return EditResult{numbered(7), ""}; });
  session.edit(numbered(1));
  EXPECT_NE(waitFor(job, session).find("Work: the level has been changed"), std::string::npos);
  EXPECT_EQ(session.level(), numbered(1));
}

TEST_F(EditJobs, SayNothingOfALevelThatHasBeenChanged) {
  job.start(session, "Work", [](const Level&, const Progress&) {
    return EditResult{std::nullopt, "Nothing is hidden."};
  });
  session.edit(numbered(1));
  EXPECT_NE(waitFor(job, session).find("Work: the level has been changed"), std::string::npos);
}

TEST_F(EditJobs, ComeTooLateAfterSavingElsewhere) {
  const TemporaryFolder folder;
  job.start(session, "Work", [](const Level&, const Progress&) { return EditResult{numbered(7), ""}; });
  testing::saveTo(session, folder / "elsewhere.json");
  EXPECT_NE(waitFor(job, session), "");
  EXPECT_EQ(session.level(), numbered(0));
}

TEST_F(EditJobs, AreDroppedWithTheirLevel) {
  std::atomic<bool> begun = false, stopped = false;
  job.start(session, "Work", [&](const Level&, const Progress& progress) {
    begun = true;
    while (!progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    stopped = true;
    return EditResult{numbered(7), "too late"};
  });
  while (!begun) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  session.startNew(numbered(2));
  EXPECT_EQ(waitFor(job, session), "");
  for (int i = 0; i < 2000 && !stopped; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_TRUE(stopped);
  EXPECT_EQ(job.update(session), std::nullopt);
  EXPECT_EQ(session.level(), numbered(2));
}

TEST_F(EditJobs, SayWhyTheyFailed) {
  job.start(session, "Work",
            [](const Level&, const Progress&) -> EditResult { throw Error("no such mesh"); });
  EXPECT_EQ(waitFor(job, session), "no such mesh");
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(session.canUndo());
}

TEST_F(EditJobs, ANewOneTakesTheOldOnesPlace) {
  std::atomic<bool> go = false;
  job.start(session, "Old", [&](const Level&, const Progress&) {
    while (!go) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return EditResult{numbered(5), "old"};
  });
  job.start(session, "New", [](const Level&, const Progress&) { return EditResult{numbered(6), "new"}; });
  go = true;
  EXPECT_EQ(waitFor(job, session), "new");
  EXPECT_EQ(session.level(), numbered(6));
  EXPECT_EQ(job.update(session), std::nullopt);
}

}  // namespace
}  // namespace anamorph
