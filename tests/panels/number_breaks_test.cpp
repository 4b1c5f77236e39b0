#include "panels/number_breaks.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

// With ~ for a blank at which no line ends.
std::string together(const std::string& text) {
  std::string shown = numbersTogether(text);
  for (std::size_t at = shown.find("\u00a0"); at != std::string::npos; at = shown.find("\u00a0"))
    shown.replace(at, 2, "~");
  return shown;
}

TEST(NumberBreaks, KeepUnitsSizesAndPlacesTogether) {
  EXPECT_EQ(together("Hidden 36,2 %, and 5 % more"), "Hidden 36,2~%, and 5~% more");
  EXPECT_EQ(together("58.1 x 20.8 x 56.2 mm with"), "58.1~x~20.8~x~56.2~mm with");
  EXPECT_EQ(together("near (23,9; -38,2; 51,7) 0,02 mm, then"), "near (23,9;~-38,2;~51,7) 0,02~mm, then");
  EXPECT_EQ(together("near (23.9, -38.2, 51.7)"), "near (23.9,~-38.2,~51.7)");
  EXPECT_EQ(together("over 4.0 mm² of it"), "over 4.0~mm² of it");
}

TEST(NumberBreaks, LeaveWordsAlone) {
  for (const char* text :
       {"", " ", "3 maximal", "with 12 mmm", "the steps 1, 2, 3", "a x 3", "(see) 1, 2", "x 3"})
    EXPECT_EQ(together(text), text);
}

}  // namespace
}  // namespace anamorph
