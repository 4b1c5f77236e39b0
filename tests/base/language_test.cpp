#include "base/language.h"

#include <gtest/gtest.h>

namespace anamorph {
namespace {

class LanguageTest : public testing::Test {
 protected:
  ~LanguageTest() override { setLanguage(nullptr); }
};

TEST_F(LanguageTest, PutsValuesIntoTheTranslation) {
  const TextTable table{{"{} of {:.1f}", "{1:.1f}, davon {0}"}};
  EXPECT_EQ(trFormat("{} of {:.1f}", 1, 2.5), "1 of 2.5");
  setLanguage(&table);
  EXPECT_EQ(trFormat("{} of {:.1f}", 1, 2.5), "2.5, davon 1");
}

TEST_F(LanguageTest, ShowsTheEnglishTextWhereTheTranslationIsNoFormat) {
  for (const char* broken : {"Opgeslagen: {", "}", "{} {}", "{:d}", "{x}"}) {
    const TextTable table{{"Saved: {}", broken}};
    setLanguage(&table);
    EXPECT_EQ(trFormat("Saved: {}", "a.json"), "Saved: a.json") << broken;
  }
}

}  // namespace
}  // namespace anamorph
