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

struct Written {
  double value;
  const char* spec;
  const char *english, *dutch;
};

TEST_F(LanguageTest, WritesNumbersAsPeopleDo) {
  const TextTable table{{"0.5", "0,5"}};
  for (const Written& row : {Written{0.25, ".2f", "0.25", "0,25"},
                             {-0.0, "", "0", "0"},
                             {-0.001, ".2f", "0.00", "0,00"},
                             {-0.006, ".2f", "-0.01", "-0,01"},
                             {-0.0, "+.2f", "0.00", "0,00"},
                             {1.5, "+.2f", "+1.50", "+1,50"},
                             {1e6, "g", "1000000", "1000000"},
                             {-1e6, "g", "-1000000", "-1000000"},
                             {1e-6, "g", "0.000001", "0,000001"},
                             {1234567, ".3g", "1230000", "1230000"},
                             {1.25e-5, ".3g", "0.0000125", "0,0000125"},
                             {12, ".0f", "12", "12"}}) {
    setLanguage(nullptr);
    EXPECT_EQ(shownNumber(row.value, row.spec), row.english);
    setLanguage(&table);
    EXPECT_EQ(shownNumber(row.value, row.spec), row.dutch);
  }
}

TEST_F(LanguageTest, WritesAllNumbersOfATextSo) {
  const TextTable table{{"0.5", "0,5"}, {"{:.1f} of {}", "{:.1f} van {}"}};
  setLanguage(&table);
  EXPECT_EQ(trFormat("{:.1f} of {}", 2.5f, 3), "2,5 van 3");
  EXPECT_EQ(shownFormat("({:.2f}, {:g}) {}", -0.001, 1e6, "a.b"), "(0,00, 1000000) a.b");
}

}  // namespace
}  // namespace anamorph
