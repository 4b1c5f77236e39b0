#include "base/text.h"

#include <string>

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

TEST(Shortened, CutsBetweenCharacters) {
  EXPECT_EQ(shortened("abc", 3), "abc");
  EXPECT_EQ(shortened("abcd", 3), "abc...");
  EXPECT_EQ(shortened("aäb", 2), "a...");
  EXPECT_EQ(shortened("aäb", 3), "aä...");
  EXPECT_EQ(shortened("\x80\x80\x80", 2), "...");
}

struct Printed {
  const char* name;
  std::string text, printed;
};

class Printable : public testing::TestWithParam<Printed> {};

TEST_P(Printable, EscapesWhatATerminalWouldObey) {
  EXPECT_EQ(printable(GetParam().text), GetParam().printed);
}

INSTANTIATE_TEST_SUITE_P(
    , Printable,
    testing::Values(Printed{"Letters", "Größe \"1 : 2\" → 日本 😀", "Größe \"1 : 2\" → 日本 😀"},
                    Printed{"Backslash", "C:\\x", "C:\\x"}, Printed{"Line", "a\nb\r\tc", "a\\nb\\015\\tc"},
                    Printed{"Escape", "\x1b[31mred\x7f", "\\033[31mred\\177"},
                    Printed{"Zero", std::string("a\0b", 3), "a\\000b"},
                    Printed{"EightBitEscape", "\xC2\x9B", "\\302\\233"},
                    Printed{"RightToLeft", "a\u202Eb\u2066", "a\\342\\200\\256b\\342\\201\\246"},
                    Printed{"LineSeparator", "\u2028", "\\342\\200\\250"},
                    Printed{"HalfACharacter", "\xE2\x80", "\\342\\200"},
                    Printed{"Surrogate", "\xED\xA0\x80", "\\355\\240\\200"}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace anamorph
