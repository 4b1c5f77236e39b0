#include "edit/status.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

Level numbered(int number) {
  Level level;
  level.sculpture.depthScale = 1 + number;
  return level;
}

TEST(Status, OfALevelGoesWithIt) {
  Status status;
  status.sayOf(numbered(0), "Nothing is hidden.");
  status.update(numbered(0));
  EXPECT_EQ(status.text(), "Nothing is hidden.");
  status.update(numbered(1));
  EXPECT_EQ(status.text(), "");
  status.update(numbered(0));
  EXPECT_EQ(status.text(), "") << "what is gone does not come back";
}

TEST(Status, OfSomethingElseStaysUntilTheNextOne) {
  Status status;
  status.say("The disk is full.");
  status.update(numbered(1));
  EXPECT_EQ(status.text(), "The disk is full.");
  status.sayOf(numbered(1), "Saved.");
  EXPECT_EQ(status.text(), "Saved.");
  status.update(numbered(2));
  EXPECT_EQ(status.text(), "");
}

}  // namespace
}  // namespace anamorph
