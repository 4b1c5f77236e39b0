#include "app/key_taps.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

TEST(KeyTaps, AShortTapIsLetGoOfAfterTheFrame) {
  KeyTaps taps;
  taps.press(65);
  EXPECT_TRUE(taps.waits({65, 1, 2}));
  const auto releases = taps.takeReleases();
  ASSERT_EQ(releases.size(), 1u);
  EXPECT_EQ(releases[0].key, 65);
  EXPECT_EQ(releases[0].code, 1);
  EXPECT_EQ(releases[0].modifiers, 2);
  EXPECT_TRUE(taps.takeReleases().empty());
}

TEST(KeyTaps, ALongPressIsLetGoOfAtOnce) {
  KeyTaps taps;
  taps.press(65);
  taps.takeReleases();
  EXPECT_FALSE(taps.waits({65, 1, 0}));
  EXPECT_FALSE(taps.waits({66, 1, 0})) << "pressed before anybody looked";
}

TEST(KeyTaps, AKeyThatIsHeldAgainStaysDown) {
  KeyTaps taps;
  taps.press(65);
  taps.press(66);
  EXPECT_TRUE(taps.waits({65, 1, 0}));
  EXPECT_TRUE(taps.waits({66, 1, 0}));
  taps.press(65);
  const auto releases = taps.takeReleases();
  ASSERT_EQ(releases.size(), 1u);
  EXPECT_EQ(releases[0].key, 66);
}

}  // namespace
}  // namespace anamorph
