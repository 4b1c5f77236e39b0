#include "geometry/file_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace anamorph {
namespace {

TEST(FileText, NumbersThatAreNumbers) {
  const std::pair<const char*, double> cases[] = {
      {"0", 0},
      {"-0", -0.0},
      {"+1", 1},
      {"1.", 1},
      {".5", 0.5},
      {"-.5", -0.5},
      {"+.5e+1", 5},
      {"1e3", 1000},
      {"1E-3", 0.001},
      {"0.1", 0.1},
      {"5e-324", 5e-324},
      {"1e-400", 0},
      {"-1e-400", -0.0},
      {"1e300", 1e300},
      {"007", 7},
      {"1.5D+02", 150},
      {"-25d-1", -2.5},
      {"9007199254740993", 9007199254740992.0},
      {"123456789012345678901234567890e-20", 1234567890.1234567890},
      {"0.3000000000000000166533453693773481063544750213623046875", 0.30000000000000004}};
  for (const auto& [text, value] : cases) {
    const auto number = parseNumber(text);
    ASSERT_TRUE(number) << text;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(*number), std::bit_cast<std::uint64_t>(value)) << text;
  }
}

TEST(FileText, NumbersThatAreNone) {
  for (const char* text :
       {"",    "+",     "-",        ".",     "e5",     "1e", "1e+", "nan",       "-nan", "NaN",
        "inf", "-inf",  "infinity", "1e999", "-1e999", "1x", "1,5", "0x10",      "--1",  "+-1",
        "1 2", "1.2.3", "1e5.5",    "#",     "D5",     "d",  "1D",  "-nan(ind)", "0xd"}) {
    EXPECT_FALSE(parseNumber(text)) << text;
  }
}

TEST(FileText, EveryDoubleReadsBackFromItsShortestForm) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 100000; ++i) {
    const std::uint64_t bits = random();
    const auto value = std::bit_cast<double>(bits);
    if (!std::isfinite(value)) continue;
    const std::string text = fmt::format("{}", value);
    const auto number = parseNumber(text);
    ASSERT_TRUE(number && std::bit_cast<std::uint64_t>(*number) == bits) << text << ", seed 7, case " << i;
  }
}

TEST(FileText, CoordinatesEndAtABillion) {
  EXPECT_EQ(parseCoordinate("-1e9"), -1e9);
  EXPECT_FALSE(parseCoordinate("1000000000.1"));
  EXPECT_TRUE(areCoordinates({1e9, -1e9, 0}));
  EXPECT_FALSE(areCoordinates({0, NAN, 0}));
  EXPECT_FALSE(areCoordinates({0, 0, -INFINITY}));
}

TEST(FileText, WordsAreSeparatedByAnyBlanks) {
  std::string_view text = " \t one\r\ntwo\v\f3";
  EXPECT_EQ(takeWord(text), "one");
  EXPECT_EQ(takeWord(text), "two");
  EXPECT_EQ(takeWord(text), "3");
  EXPECT_EQ(takeWord(text), "");
  text = "# one\r# two\n\n #three\nfour # five";
  EXPECT_EQ(takeWordPastComments(text), "four");
  EXPECT_EQ(takeWordPastComments(text), "");
  EXPECT_EQ(trimmed("\t a b \r\n"), "a b");
  EXPECT_EQ(trimmed(" \n"), "");
}

TEST(FileText, QuotesAreShortAndPrintable) {
  EXPECT_EQ(inQuotes("a b"), "\"a b\"");
  EXPECT_EQ(inQuotes(std::string_view("\0\xff\n\x1b", 4)), "\"\\x00\\xff\\x0a\\x1b\"");
  EXPECT_EQ(inQuotes(std::string(50, 'x')), "\"" + std::string(40, 'x') + "...\"");
  EXPECT_EQ(inQuotesOrEnd(""), "the end of the file");
}

std::vector<std::pair<std::size_t, std::string>> linesOf(std::string_view text) {
  std::vector<std::pair<std::size_t, std::string>> lines;
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) lines.emplace_back(reader.number(), line);
  return lines;
}

TEST(FileText, LinesEndInAnyOfThreeWays) {
  const std::vector<std::pair<std::size_t, std::string>> expected{{1, "a"}, {2, ""}, {3, "b"}};
  for (const char* text : {"a\n\nb", "a\n\nb\n", "a\r\n\r\nb\r\n", "a\r\rb", "a\r\rb\r",
                           "\xEF\xBB\xBF"
                           "a\n\nb"}) {
    EXPECT_EQ(linesOf(text), expected) << inQuotes(text);
  }
  EXPECT_TRUE(linesOf("").empty());
}

TEST(FileText, LineEndsMayBeMixedAndPaddingIsNoLine) {
  const std::vector<std::pair<std::size_t, std::string>> expected{
      {1, "a"}, {2, "b"}, {3, ""}, {4, "c"}, {5, "d"}};
  EXPECT_EQ(linesOf("a\rb\n\r\nc\rd"), expected);
  EXPECT_EQ(linesOf(std::string("a\r\nb\r\n\r\nc\r\nd\r\n \x1a\0\0\0", 20)), expected);
}

TEST(FileText, ABackslashContinuesALineThatAsksForIt) {
  const std::pair<std::string, std::string> cases[] = {
      {"a\\\n1\\\r\n2\nd", "a 1 2"},
      {"a \\ \t\n 1\n", "a   1"},
      {"a\\", "a "},
      {"a\\\nb", "a "},  // no continuation begins with a letter
      {"a\nb", "a"}};
  for (const auto& [text, joined] : cases) {
    LineReader lines(text);
    std::string_view line;
    ASSERT_TRUE(lines.next(line)) << text;
    EXPECT_EQ(lines.continued(line), joined) << text;
    EXPECT_EQ(lines.number(), 1u);
  }
}

TEST(FileText, PaddingIsByteOrderMarkBlanksZerosAndControlZ) {
  EXPECT_EQ(withoutPadding(std::string_view("\xEF\xBB\xBF a b \n\0\x1a\n", 12)), " a b");
  EXPECT_TRUE(isPadding(std::string_view("\0 \x1a\n", 4)));
  EXPECT_FALSE(isPadding(std::string_view("\0x", 2)));
}

TEST(FileText, KeywordsMayBeInCapitals) {
  EXPECT_TRUE(isKeyword("EndSolid", "endsolid"));
  EXPECT_FALSE(isKeyword("endsoli", "endsolid"));
  EXPECT_FALSE(isKeyword("", "endsolid"));
}

TEST(FileText, DecimalCommasAreNamed) {
  EXPECT_NE(decimalCommaHint("x 1,5 2"), "");
  for (const char* text : {"", ",", "1,", ",5", "1, 5", "a,b", "1.5"})
    EXPECT_EQ(decimalCommaHint(text), "") << text;
}

TEST(FileText, LineOfAnOffset) {
  EXPECT_EQ(lineAt("a\nb\nc", 0), "line 1");
  EXPECT_EQ(lineAt("a\nb\nc", 4), "line 3");
  EXPECT_EQ(lineAt("a\rb\rc", 4), "line 3");
}

}  // namespace
}  // namespace anamorph
