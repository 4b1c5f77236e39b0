#include "edit/save_job.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.h"

namespace anamorph {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;
namespace fs = std::filesystem;

constexpr double patience = 20;  // seconds

class SaveJobs : public ::testing::Test {
 protected:
  SaveJobs() { session.startNew(deep(1)); }

  static Level deep(double depthScale) {
    Level level;
    level.sculpture.depthScale = depthScale;
    return level;
  }
  static double depthIn(const fs::path& file) { return loadLevel(file).level.sculpture.depthScale; }
  SaveOutcome saved(const std::string& name, std::optional<FileTime> known = std::nullopt) {
    job.start(session, folder / name, known);
    return job.take(session, patience).value();
  }

  TemporaryFolder folder;
  Session session;
  SaveJob job;
};

TEST_F(SaveJobs, WriteTheLevelAndTellTheSession) {
  const SaveOutcome outcome = saved("a.json");
  EXPECT_EQ(outcome.failure, "");
  EXPECT_EQ(outcome.path, folder / "a.json");
  EXPECT_EQ(depthIn(folder / "a.json"), 1);
  EXPECT_EQ(session.path(), folder / "a.json");
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(session.fileTime(), timeOf(folder / "a.json"));
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.take(session, patience)) << "once";
}

TEST_F(SaveJobs, WhatIsEditedMeanwhileStaysAndIsNotSaved) {
  job.start(session, folder / "a.json");
  session.change(deep(2));
  EXPECT_TRUE(job.take(session, patience));
  EXPECT_EQ(depthIn(folder / "a.json"), 1);
  EXPECT_TRUE(session.modified() && session.changing());
  session.finishChange();
  EXPECT_EQ(session.level().sculpture.depthScale, 2);
  session.undo();
  EXPECT_FALSE(session.modified());
}

TEST_F(SaveJobs, AnotherLevelThatWasOpenedMeanwhileIsNotTheOneSaved) {
  job.start(session, folder / "a.json");
  session.startNew(deep(3));
  EXPECT_TRUE(job.take(session, patience));
  EXPECT_EQ(depthIn(folder / "a.json"), 1);
  EXPECT_TRUE(session.path().empty());
  EXPECT_EQ(session.level().sculpture.depthScale, 3);
}

TEST_F(SaveJobs, WhatAnotherProgramWroteIsReplacedOnlyWithoutAKnownTime) {
  saved("a.json");
  const auto known = session.fileTime();
  saveLevel(folder / "a.json", deep(7));
  fs::last_write_time(folder / "a.json", *known + std::chrono::seconds(5));
  EXPECT_TRUE(saved("a.json", known).changedElsewhere);
  EXPECT_EQ(depthIn(folder / "a.json"), 7);
  EXPECT_EQ(session.fileTime(), known);
  EXPECT_FALSE(saved("a.json").changedElsewhere);
  EXPECT_EQ(depthIn(folder / "a.json"), 1);
}

TEST_F(SaveJobs, AFailureChangesNothing) {
  const SaveOutcome outcome = saved("no/such/folder.json");
  EXPECT_THAT(outcome.failure, HasSubstr("no/such/folder.json: cannot"));
  EXPECT_TRUE(session.path().empty());
  EXPECT_FALSE(job.busy());
}

}  // namespace
}  // namespace anamorph
