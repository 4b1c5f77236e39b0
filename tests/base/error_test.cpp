#include "base/error.h"

#include <gtest/gtest.h>

#include <string>

#include "base/check.h"

namespace anamorph {
namespace {

TEST(Error, ReadsFileWhereMessage) {
  const Error error("expected a number > 0, got -4", "levels/3.json", "/mirror/radius");
  EXPECT_STREQ(error.what(), "levels/3.json: /mirror/radius: expected a number > 0, got -4");
  EXPECT_EQ(error.message, "expected a number > 0, got -4");
  EXPECT_EQ(error.file, "levels/3.json");
  EXPECT_EQ(error.where, "/mirror/radius");
}

TEST(Error, LeavesEmptyPartsOut) {
  EXPECT_STREQ(Error("no levels").what(), "no levels");
  EXPECT_STREQ(Error("cannot open", "a.obj").what(), "a.obj: cannot open");
  EXPECT_STREQ(Error("expected 3 numbers", "", "line 7").what(), "line 7: expected 3 numbers");
}

TEST(Check, ThrowsWithPlaceAndConditionOnlyWhenItFails) {
  EXPECT_NO_THROW(CHECK(1 + 1 == 2));
  std::string message;
  const int line = __LINE__ + 2;
  try {
    CHECK(1 + 1 == 3);
  } catch (const ProgrammingError& error) {
    message = error.what();
  }
  EXPECT_EQ(message, std::string(__FILE__) + ":" + std::to_string(line) + ": CHECK(1 + 1 == 3) failed");
}

TEST(Check, EvaluatesItsConditionOnce) {
  int count = 0;
  CHECK(++count == 1);
  EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace anamorph
