#include "cannot_run_here.h"

#include <cstdlib>
#include <optional>
#include <string>

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

namespace anamorph {
namespace {

// The environment's CI, given back at the end.
class CannotRunHere : public testing::Test {
 protected:
  CannotRunHere() {
    if (const char* const ci = std::getenv("CI")) before_ = ci;
  }
  ~CannotRunHere() override { before_ ? ::setenv("CI", before_->c_str(), 1) : ::unsetenv("CI"); }

 private:
  std::optional<std::string> before_;
};

TEST_F(CannotRunHere, FailsWhereTheProjectIsChecked) {
  ::setenv("CI", "true", 1);
  EXPECT_FATAL_FAILURE(cannotRunHere("no screen"), "no screen");
}

TEST_F(CannotRunHere, SkipsAtHome) {
  for (const char* ci : {"", "false"}) {
    ::setenv("CI", ci, 1);
    testing::TestPartResultArray results;
    {
      const testing::ScopedFakeTestPartResultReporter reporter(&results);
      cannotRunHere("no screen");
    }
    ASSERT_EQ(results.size(), 1);
    EXPECT_TRUE(results.GetTestPartResult(0).skipped());
  }
}

}  // namespace
}  // namespace anamorph
