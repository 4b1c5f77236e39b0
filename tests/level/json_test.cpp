#include "level/json.h"

#include <gtest/gtest.h>

#include <string>

#include "error_text.h"

namespace anamorph {
namespace {

std::string complaintOf(const std::string& text) {
  return withoutPlaces(errorOf([&] { parseJson(text, "f.json"); }));
}

TEST(Json, KeepsKeyOrderAndNumbersAsWritten) {
  const JsonValue json =
      parseJson(R"({"b": 1.50, "a": [true, null, 12345678901234567890, "x\u00e9"]})", "f.json");
  EXPECT_EQ(compactJson(json), R"({"b": 1.50, "a": [true, null, 12345678901234567890, "xé"]})");
  EXPECT_EQ(json.items[0].number, 1.5);
}

TEST(Json, ReadsWindowsLineEndsAndByteOrderMark) {
  EXPECT_EQ(parseJson("\xEF\xBB\xBF{\r\n\"a\": 1\r\n}\r\n", "f.json"), parseJson(R"({"a":1})", "f.json"));
}

TEST(Json, PutsShortValuesOnOneLine) {
  EXPECT_EQ(
      formatJson(parseJson(R"({"p":[0,-12,8],"o":{"x":1,"y":{}},"e":[],"s":{"q":[[1],[2]]}})", "f.json")),
      "{\n"
      "  \"p\": [0, -12, 8],\n"
      "  \"o\": {\n"
      "    \"x\": 1,\n"
      "    \"y\": {}\n"
      "  },\n"
      "  \"e\": [],\n"
      "  \"s\": {\"q\": [[1], [2]]}\n"
      "}\n");
}

TEST(Json, BreaksWhatDoesNotFitTheLine) {
  const std::string item = '"' + std::string(70, 'x') + '"';
  EXPECT_EQ(formatJson(parseJson("{\"a\":[" + item + "," + item + "]}", "f.json")),
            "{\n  \"a\": [\n    " + item + ",\n    " + item + "\n  ]\n}\n");
}

TEST(Json, FormattedTextReadsBack) {
  const JsonValue json =
      parseJson(R"([{"a": [1, [2, {"b": "\"\\\u0000\n\u2028"}]]}, "", 1e-300, -0.0, {}])", "f.json");
  EXPECT_EQ(parseJson(formatJson(json), "f.json"), json);
  EXPECT_EQ(parseJson(compactJson(json), "f.json"), json);
}

TEST(Json, ReplacesBytesThatAreNotUtf8WhenWriting) {
  EXPECT_EQ(quoteJson("a\xFFz"), "\"a\xEF\xBF\xBDz\"");
}

struct BadText {
  const char* name;
  std::string text;
  const char* message;
};

void PrintTo(const BadText& bad, std::ostream* out) {
  *out << bad.name;
}

class BadJson : public testing::TestWithParam<BadText> {};

TEST_P(BadJson, IsRefusedWithItsPlace) {
  EXPECT_EQ(complaintOf(GetParam().text), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    , BadJson,
    testing::Values(
        BadText{"Empty", "", "f.json: expected JSON, got an empty file"},
        BadText{"OnlySpace", " \r\n\t", "f.json: expected JSON, got an empty file"},
        BadText{"OnlyByteOrderMark", "\xEF\xBB\xBF", "f.json: expected JSON, got an empty file"},
        BadText{"DoubleComma", "{\n  \"a\": 1,,\n}",
                "f.json: line 2, column 10: syntax error while parsing object key - unexpected ','; expected "
                "string "
                "literal"},
        BadText{"TrailingComma", "{\"a\": 1,\n}",
                "f.json: expected another value after this comma, got a closing bracket: "
                "remove the comma"},
        BadText{"TrailingCommaInArray", "[1, 2 , ]",
                "f.json: expected another value after this comma, got a closing bracket: "
                "remove the comma"},
        BadText{"Truncated", "{\"a\": [1, 2",
                "f.json: line 1, column 12: syntax error while parsing array - unexpected end of input; "
                "expected ']'"},
        BadText{"Comment", "{} // x",
                "f.json: line 1, column 4: syntax error while parsing value - invalid literal; last read: "
                "'{} /'; "
                "expected end of input"},
        BadText{"SmartQuote", "{“a”: 1}",
                "f.json: line 1, column 2: syntax error while parsing object key - invalid literal; last "
                "read: '{“'; "
                "expected string literal"},
        BadText{"TwoDocuments", "{}\n{}",
                "f.json: line 2, column 1: syntax error while parsing value - unexpected '{'; expected end "
                "of input"},
        BadText{
            "NotANumber", "[nan]",
            "f.json: line 1, column 3: syntax error while parsing value - invalid literal; last read: '[na'"},
        BadText{"NumberTooLarge", "{\"a\": [0, {\"b/~\": 1e999}]}",
                "f.json: /a/1/b~1~0: expected a number below 1.8e308, got 1e999"},
        BadText{"NumberTooLargeInArray", "[[0], [0, -1e999]]",
                "f.json: /1/1: expected a number below 1.8e308, got -1e999"},
        BadText{"NumberTooLargeAlone", "1e999", "f.json: expected a number below 1.8e308, got 1e999"},
        BadText{"KeyTwice", "{\"a\": 1, \"b\": [{\"x\": 1, \"y\": 2, \"x\": 3}]}",
                "f.json: /b/0/x: expected each key once, got it twice"},
        BadText{"InvalidByte", "{\"a\": \"\xFF\"}", "f.json: byte 7: expected UTF-8 text, got the byte 0xff"},
        BadText{"OverlongSlash", "\"\xC0\xAF\"", "f.json: byte 1: expected UTF-8 text, got the byte 0xc0"},
        BadText{"OverlongThreeBytes", "\"\xE0\x9F\xBF\"",
                "f.json: byte 1: expected UTF-8 text, got the byte 0xe0"},
        BadText{"OverlongFourBytes", "\"\xF0\x8F\xBF\xBF\"",
                "f.json: byte 1: expected UTF-8 text, got the byte 0xf0"},
        BadText{"Surrogate", "\"\xED\xA0\x80\"", "f.json: byte 1: expected UTF-8 text, got the byte 0xed"},
        BadText{"AboveUnicode", "\"\xF4\x90\x80\x80\"",
                "f.json: byte 1: expected UTF-8 text, got the byte 0xf4"},
        BadText{"CutCharacter", "\"\xE9\x95", "f.json: byte 1: expected UTF-8 text, got the byte 0xe9"},
        BadText{"ZeroByte", std::string("{}\0x", 4),
                "f.json: byte 2: expected UTF-8 text, got the byte 0x00"},
        BadText{"LoneEscapedSurrogate", "\"\\ud800\"",
                "f.json: line 1, column 8: syntax error while parsing value - invalid string: surrogate "
                "U+D800..U+DBFF "
                "must be followed by U+DC00..U+DFFF; last read: '\"\\ud800\"'"}),
    [](const auto& bad) { return std::string(bad.param.name); });

TEST(Json, RefusesDeepNestingWithoutRecursion) {
  const std::string limit = "f.json: expected at most 64 levels of nesting, got more";
  EXPECT_EQ(complaintOf(std::string(100000, '[')), limit);
  std::string objects;
  for (int i = 0; i < 100000; ++i) objects += "{\"a\":";
  EXPECT_EQ(complaintOf(objects), limit);
  EXPECT_EQ(complaintOf(std::string(65, '[') + std::string(65, ']')), limit);
  EXPECT_EQ(complaintOf(std::string(64, '[') + std::string(64, ']')), "no error");
}

TEST(Json, RefusesMoreValuesThanItsLimit) {
  std::string text = "[";
  for (std::size_t i = 1; i < maxJsonValues; ++i) text += "0,";
  EXPECT_EQ(complaintOf(text + "0]"), "f.json: expected at most 1000000 values in the file, got more");
  text.back() = ']';
  EXPECT_EQ(complaintOf(text), "no error");
}

TEST(Json, LongTokensAreCutBetweenCharacters) {
  std::string umlauts;
  for (int i = 0; i < 5000; ++i) umlauts += "ä";
  const std::string message = complaintOf("\"" + umlauts);
  EXPECT_LT(message.size(), 300u);
  EXPECT_EQ(quoteJson(message).find("\xEF\xBF\xBD"), std::string::npos) << message;
}

TEST(Json, DescribesValuesShortly) {
  const auto describe = [](const std::string& text) { return describeJson(parseJson(text, "f.json")); };
  EXPECT_EQ(describe("-4"), "-4");
  EXPECT_EQ(describe("null"), "null");
  EXPECT_EQ(describe("\"on\""), "\"on\"");
  EXPECT_EQ(describe("[0, 1]"), "[0, 1]");
  EXPECT_EQ(describe("{\"a\": 1}"), "an object");
  EXPECT_EQ(describe("[\"" + std::string(100, 'x') + "\"]"), "an array");
  EXPECT_EQ(describe('"' + std::string(100, 'x') + '"'), '"' + std::string(59, 'x') + "...");
}

}  // namespace
}  // namespace anamorph
