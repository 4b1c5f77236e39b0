#include "base/text.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

TEST(Alternatives, AreReadAsASentence) {
  EXPECT_EQ(alternatives({}), "");
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b"}), "a or b");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

TEST(Remarks, FollowTheText) {
  EXPECT_EQ(withRemarks("Saved: a", {}), "Saved: a");
  EXPECT_EQ(withRemarks("Saved: a", {"b", "c"}), "Saved: a; b; c");
}

}  // namespace
}  // namespace anamorph
