#include "base/spelling.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

const std::vector<std::string> known{"plane", "cylinder", "sphere", "cone", "eye", "depthScale"};

TEST(Spelling, FindsWhatWasMeant) {
  struct Case {
    const char *word, *meant;
  };
  for (const Case& c : {Case{"cilinder", "cylinder"}, Case{"Sphere", "sphere"}, Case{"shpere", "sphere"},
                        Case{"plan", "plane"}, Case{"planes", "plane"}, Case{"eyes", "eye"},
                        Case{"con", "cone"}, Case{"depth_scale", "depthScale"}}) {
    EXPECT_EQ(nearestWord(c.word, known), c.meant) << c.word;
  }
}

TEST(Spelling, GuessesNothingFarAway) {
  for (const char* word : {"", "x", "egg", "torus", "hyperboloid", "lens"}) {
    EXPECT_EQ(nearestWord(word, known), "") << word;
  }
  EXPECT_EQ(nearestWord(std::string(100000, 'e'), known), "");
  EXPECT_EQ(nearestWord("plane", {}), "");
}

TEST(Spelling, IsAPartOfASentence) {
  EXPECT_EQ(didYouMean("radus", {"radius"}), "; did you mean \"radius\"?");
  EXPECT_EQ(didYouMean("egg", known), "");
}

}  // namespace
}  // namespace anamorph
