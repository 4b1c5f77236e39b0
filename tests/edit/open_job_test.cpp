#include "edit/open_job.h"

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/program.h"
#include "error_text.h"

namespace anamorph {
namespace {

using testing::TemporaryFolder;

constexpr double patience = 20;  // seconds

class OpenJobs : public ::testing::Test {
 protected:
  OpenJobs() {
    for (int i = 1; i <= 2; ++i) {
      Level level;
      level.sculpture.depthScale = i;
      saveLevel(folder / (std::to_string(i) + ".json"), level);
    }
  }
  TemporaryFolder folder;
  OpenJob job;
};

TEST_F(OpenJobs, BringAFileOnce) {
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.take(patience));
  job.start(folder / "1.json");
  EXPECT_TRUE(job.busy());
  const auto file = job.take(patience);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->path, folder / "1.json");
  EXPECT_EQ(file->loaded.level.sculpture.depthScale, 1);
  EXPECT_TRUE(file->written);
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.take(patience));
}

TEST_F(OpenJobs, SayWhatIsWrongOnce) {
  job.start(folder / "none.json");
  EXPECT_EQ(errorOf([&] { job.take(patience); }),
            (folder / "none.json") + ": cannot open: No such file or directory");
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.take());
}

TEST_F(OpenJobs, AnotherFormatIsNamedWithTheWayOut) {
  const std::string step = std::string(ANAMORPH_TEST_DATA) + "/field/formats/m.step";
  job.start(step);
  const std::string message = errorOf([&] { job.take(patience); });
  EXPECT_EQ(message.find(step + ": expected a level; "), 0u) << message;
  EXPECT_NE(message.find("STEP"), std::string::npos) << message;
  EXPECT_EQ(message.find("syntax error"), std::string::npos) << message;
}

TEST_F(OpenJobs, TheLatestWins) {
  job.start(folder / "none.json");
  job.start(folder / "1.json");
  job.start(folder / "2.json");
  const auto file = job.take(patience);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->path, folder / "2.json");
}

TEST_F(OpenJobs, BringNothingWhenCancelled) {
  job.start(folder / "1.json");
  job.cancel();
  EXPECT_FALSE(job.busy());
  EXPECT_FALSE(job.take(0.2));
}

}  // namespace
}  // namespace anamorph
