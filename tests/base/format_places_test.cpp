#include "base/format_places.h"

#include <string>

#include <fmt/args.h>
#include <gtest/gtest.h>

namespace anamorph {
namespace {

struct Translation {
  const char* name;
  std::string english, translation;
  bool fits;
};

class TranslationOfAFormat : public testing::TestWithParam<Translation> {};

TEST_P(TranslationOfAFormat, TakesTheSameValues) {
  EXPECT_EQ(takesSameValues(GetParam().english, GetParam().translation), GetParam().fits);
}

INSTANTIATE_TEST_SUITE_P(, TranslationOfAFormat,
                         testing::Values(Translation{"Words", "Save", "Opslaan", true},
                                         Translation{"Same", "{} of {:.1f}", "{} van {:.1f}", true},
                                         Translation{"Numbered", "{} of {:.1f}", "{1:.1f}: {0}", true},
                                         Translation{"Twice", "{} of {}", "{0} {1} {0}", true},
                                         Translation{"OneLess", "{} of {}", "{} uit", false},
                                         Translation{"OneMore", "{} of {}", "{} {} {}", false},
                                         Translation{"OtherSpecification", "{:.1f} mm", "{:d} mm", false},
                                         Translation{"Exchanged", "{} of {:.1f}", "{:.1f} van {}", false},
                                         Translation{"Named", "{}", "{x}", false},
                                         Translation{"NumberedAndNot", "{} of {}", "{} {1}", false},
                                         Translation{"LoneOpen", "Save", "Opslaan {", false},
                                         Translation{"LoneClose", "Saved: {}", "}{}", false},
                                         Translation{"Nested", "{}", "{:{}}", false},
                                         Translation{"Escaped", "Saved: {}", "{{{}}}", true},
                                         Translation{"EscapedAlone", "Save", "{{}} {{", true},
                                         Translation{"NoFormatInEnglish", "f = {x | x > 0", "f {{ = {x",
                                                     true}),
                         [](const auto& each) { return std::string(each.param.name); });

// What is accepted never fails in fmt with values that fit the English text, and nothing else is known of it.
TEST(FormatPlaces, AcceptsOnlyWhatCanBeFormatted) {
  const std::string letters = "{}:0a1";
  const std::string english = "{} {}";
  std::size_t accepted = 0;
  for (std::size_t number = 0; number < 6 * 6 * 6 * 6 * 6 * 6; ++number) {
    std::string text;
    for (std::size_t rest = number; text.size() < 6; rest /= 6) text += letters[rest % 6];
    if (!takesSameValues(english, text)) continue;
    ++accepted;
    EXPECT_NO_THROW(fmt::vformat(text, fmt::make_format_args("x", "y"))) << text;
  }
  EXPECT_GT(accepted, 5u);
}

}  // namespace
}  // namespace anamorph
