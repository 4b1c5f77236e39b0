#include "math/box.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

TEST(Box, ANewOneIsEmpty) {
  EXPECT_TRUE(Box{}.empty());
  EXPECT_EQ(Box{}, Box{});
}

TEST(Box, OnePointMakesItABoxWithoutSize) {
  Box box;
  box.extend({1, -2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.min, Point(1, -2, 3));
  EXPECT_EQ(box.max, Point(1, -2, 3));
  EXPECT_EQ(box.size(), Vector(0));
  EXPECT_EQ(box.diagonal(), 0);
}

TEST(Box, HoldsAllItsPoints) {
  Box box;
  for (const Point& p : {Point(1, 5, -1), Point(-3, 2, 0), Point(0, 3, 11)}) box.extend(p);
  EXPECT_EQ(box.min, Point(-3, 2, -1));
  EXPECT_EQ(box.max, Point(1, 5, 11));
  EXPECT_EQ(box.centre(), Point(-1, 3.5, 5));
  EXPECT_EQ(box.size(), Vector(4, 3, 12));
  EXPECT_EQ(box.diagonal(), 13);
}

}  // namespace
}  // namespace anamorph
