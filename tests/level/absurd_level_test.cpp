// Levels as nobody would write them in earnest: each is refused with a clear message, or works.

#include <string>

#include <gtest/gtest.h>

#include "error_text.h"
#include "level/level_json.h"
#include "level/limits.h"

namespace anamorph {
namespace {

// The smallest level there is, with other members in front.
std::string levelWith(const std::string& members) {
  return "{" + members +
         R"("format": "anamorph-level", "version": 1,
            "optic": {"kind": "mirror", "shape": {"type": "sphere", "centre": [0, 0, 5], "radius": 5}},
            "camera": {"eye": [0, -12, 5], "target": [0, 5, 5]}, "original": {"shape": {"type": "box"}}})";
}

std::string repeated(const std::string& piece, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i) text += (i > 0 ? ", " : "") + piece;
  return text;
}

std::string letters(std::size_t count) {
  return '"' + std::string(count, 'x') + '"';
}

std::string lesson(const std::string& steps) {
  return R"("lesson": {"id": "l", "steps": [)" + steps + "]}, ";
}

std::string step(const std::string& why) {
  return R"({"id": "s", "title": "", "do": "", "why": )" + why + "}";
}

std::string numberedSteps(int count, const std::string& why) {
  std::string steps;
  for (int i = 0; i < count; ++i) {
    steps += (i > 0 ? ", " : "") + step(why).insert(9, std::to_string(i));
  }
  return steps;
}

std::string utf16(const std::string& ascii, bool littleEndian) {
  std::string text = littleEndian ? "\xFF\xFE" : "\xFE\xFF";
  for (const char c : ascii) text += littleEndian ? std::string{c, '\0'} : std::string{'\0', c};
  return text;
}

struct Absurd {
  const char* name;
  std::string text;
  const char* message;
};

void PrintTo(const Absurd& level, std::ostream* out) {
  *out << level.name;
}

class AbsurdLevel : public testing::TestWithParam<Absurd> {};

TEST_P(AbsurdLevel, IsRefusedOrWorks) {
  EXPECT_EQ(withoutPlaces(errorOf([&] {
              const Level level = parseLevel(GetParam().text, "l.json").level;
              EXPECT_EQ(parseLevel(formatLevel(level), "l.json").level, level);
            })),
            GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    , AbsurdLevel,
    testing::Values(
        Absurd{"Plain", levelWith(""), "no error"},
        Absurd{"ManyLights",
               levelWith("\"lights\": [" + repeated(R"({"position": [0, 0, 9]})", 10000) + "], "),
               "l.json: /lights: expected at most 64 items, got 10000"},
        Absurd{"ManySteps", levelWith(lesson(numberedSteps(10000, "\"\""))),
               "l.json: /lesson/steps: expected at most 100 items, got 10000"},
        Absurd{"LongText", levelWith("\"title\": " + letters(limits::mostTextBytes) + ", "), "no error"},
        Absurd{"TooLongTitle", levelWith("\"title\": " + letters(limits::mostTextBytes + 1) + ", "),
               "l.json: /title: expected at most 65536 bytes, got 65537"},
        Absurd{"TooLongDescription", levelWith("\"description\": " + letters(1 << 20) + ", "),
               "l.json: /description: expected at most 65536 bytes, got 1048576"},
        Absurd{"TooLongStep", levelWith(lesson(step(letters(100'000)))),
               "l.json: /lesson/steps/0/why: expected at most 65536 bytes, got 100000"},
        Absurd{"TooLongLesson", levelWith(lesson(numberedSteps(20, letters(60'000)))),
               "l.json: /lesson: expected at most 1048576 bytes, got 1200992"},
        Absurd{"NumberBeyondAll", levelWith("\"background\": {\"top\": [0, 0, 1e308]}, "),
               "l.json: /background/top/2: expected a number from 0 to 1, got 1e308"},
        Absurd{"NumberBelowAll", levelWith("\"ground\": {\"height\": -1e308}, "),
               "l.json: /ground/height: expected a number from -1000000 to 1000000, got -1e308"},
        Absurd{"Infinite", levelWith("\"ground\": {\"height\": 1e309}, "),
               "l.json: /ground/height: expected a number below 1.8e308, got 1e309"},
        Absurd{"TinyNumber", levelWith("\"ground\": {\"height\": 1e-320}, "), "no error"},
        Absurd{"NumberAsText", levelWith("\"ground\": {\"height\": \"NaN\"}, "),
               "l.json: /ground/height: expected a number from -1000000 to 1000000, got \"NaN\""},
        Absurd{"NullForANumber", levelWith("\"ground\": {\"height\": null}, "),
               "l.json: /ground/height: expected a number from -1000000 to 1000000, got null"},
        Absurd{"KeyTwice", levelWith("\"title\": \"a\", \"title\": \"b\", "),
               "l.json: /title: expected each key once, got it twice"},
        Absurd{"DeepUnknownKey", levelWith("\"deep\": " + std::string(70, '[') + std::string(70, ']') + ", "),
               "l.json: expected at most 64 levels of nesting, got more"},
        Absurd{"ByteOrderMark", "\xEF\xBB\xBF" + levelWith(""), "no error"},
        Absurd{"LittleEndianUtf16", utf16(levelWith(""), true),
               "l.json: byte 0: expected UTF-8 text, got the byte 0xff"},
        Absurd{"BigEndianUtf16", utf16(levelWith(""), false),
               "l.json: byte 0: expected UTF-8 text, got the byte 0xfe"},
        Absurd{"Empty", "", "l.json: expected JSON, got an empty file"},
        Absurd{
            "Nothing", "null",
            "l.json: expected a level (with \"format\": \"anamorph-level\") or a scene of the thesis (with "
            "\"Eye\" and \"Objects\"), got neither"}),
    [](const auto& each) { return std::string(each.param.name); });

TEST(AbsurdLevels, ManyUnknownKeysAreKeptAndToldOf) {
  std::string keys;
  for (int i = 0; i < 10000; ++i) keys += "\"key " + std::to_string(i) + "\": {}, ";
  const LoadedLevel loaded = parseLevel(levelWith(keys), "l.json");
  EXPECT_EQ(loaded.warnings.size(), 10000u);
  EXPECT_EQ(parseLevel(formatLevel(loaded.level), "l.json").level, loaded.level);
}

TEST(AbsurdLevels, LongKeysMakeNoLongMessages) {
  const std::string key(1'000'000, 'k');
  const LoadedLevel loaded = parseLevel(levelWith('"' + key + "\": 1, "), "l.json");
  ASSERT_EQ(loaded.warnings.size(), 1u);
  EXPECT_LT(loaded.warnings[0].size(), 500u);
  const std::string twice =
      errorOf([&] { parseLevel("{\"" + key + "\": 1, \"" + key + "\": 2}", "l.json"); });
  EXPECT_LT(twice.size(), 500u);
}

}  // namespace
}  // namespace anamorph
