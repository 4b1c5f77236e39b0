#include "pipeline/memo.h"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace anamorph {
namespace {

TEST(Memo, ComputesAgainOnlyWhenTheInputValueChanged) {
  Memo<int, std::string> memo;
  int computed = 0;
  const auto compute = [&](int n) {
    ++computed;
    return std::to_string(n);
  };
  EXPECT_EQ(memo.last(), nullptr);
  EXPECT_EQ(memo.get(1, compute), "1");
  EXPECT_EQ(memo.get(1, compute), "1");
  EXPECT_EQ(computed, 1);
  EXPECT_EQ(memo.get(2, compute), "2");
  EXPECT_EQ(memo.get(1, compute), "1");
  EXPECT_EQ(computed, 3);
}

TEST(Memo, KeepsNothingHalfMade) {
  Memo<int, int> memo;
  memo.get(1, [](int n) { return n; });
  EXPECT_THROW(memo.get(2, [](int) -> int { throw std::runtime_error("no"); }), std::runtime_error);
  EXPECT_EQ(memo.get(2, [](int n) { return 10 * n; }), 20);
}

}  // namespace
}  // namespace anamorph
