#include "base/progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace anamorph {
namespace {

TEST(Progress, ReportsAndGoesOnUntilCancelled) {
  std::vector<double> fractions;
  Progress progress{[&](double fraction) { fractions.push_back(fraction); }, {}};
  EXPECT_TRUE(progress.update(0.25));
  const CancelToken copy = progress.token;
  copy.cancel();
  EXPECT_TRUE(progress.cancelled());
  EXPECT_FALSE(progress.update(0.5));
  EXPECT_EQ(fractions, (std::vector<double>{0.25, 0.5}));
}

TEST(Progress, NeedsNobodyWhoListens) {
  EXPECT_TRUE(Progress{}.update(1));
  const CancelToken first, second;
  first.cancel();
  EXPECT_FALSE(second.cancelled());
}

}  // namespace
}  // namespace anamorph
