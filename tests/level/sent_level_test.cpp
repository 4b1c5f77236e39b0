// Levels as text: whatever mailers do to it on the way, the level comes back, or it is said what is wrong.

#include "level/sent_level.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "error_text.h"
#include "level/level_json.h"
#include "level/limits.h"
#include "level/random_level.h"

namespace anamorph {
namespace {

Level titled(const std::string& title) {
  Level level;
  level.text.edit([&](LevelText& text) { text.title = title; });
  return level;
}

// A level as a person would write it: blanks in its strings.
const std::string byHand =
    "{\"format\": \"anamorph-level\", \"version\": 1, \"title\": \"The plane mirror\",\n"
    " \"optic\": {\"kind\": \"mirror\", \"shape\": {\"type\": \"sphere\", \"centre\": [0, 0, 2.25], "
    "\"radius\": 2}},\n"
    " \"camera\": {\"eye\": [0, -9, 4], \"target\": [0, 5, 1]}, \"original\": {\"shape\": {\"type\": "
    "\"box\"}}}";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string quoted(const std::string& text, const std::string& mark) {
  std::string all = mark;
  for (const char c : text) all += c == '\n' ? "\n" + mark : std::string(1, c);
  return all;
}

struct GoodText {
  const char* what;
  std::string text;
  TextMends mends;
};

TEST(SentLevel, IsFoundInWhatMailersMakeOfIt) {
  const TextMends none, words{.wordsAround = true}, lines{.lineEnds = true}, quotes{.quoting = true};
  const TextMends quotedWords{.wordsAround = true, .quoting = true};
  const GoodText table[] = {
      {"as it is", byHand, none},
      {"blank lines around", "\n\n" + byHand + "\r\n \n", none},
      {"carriage returns", replaced(byHand, ",\n", ",\r\n"), none},
      {"a greeting", "Hello Jan,\nlook at \"this\":\n" + byHand, words},
      {"a signature", byHand + "\n--\nAda :-}", words},
      {"braces in the greeting", "Dear {Jan}, :-{ and {} too:\n" + byHand + "\n}", words},
      {"a fence", "```json\n" + byHand + "\n```", words},
      {"quoted", quoted(byHand, "> "), quotes},
      {"quoted twice", quoted(byHand, "> > "), quotes},
      {"quoted without blanks", quoted(byHand, ">>"), quotes},
      {"quoted with a fence", quoted("See:\n```\n" + byHand + "\n```", "> "), quotedWords},
      {"quoted below other words", "Hello {Jan}\n" + quoted(byHand, "> "), quotedWords},
      {"a string wrapped at a blank", replaced(byHand, "plane mirror", "plane\nmirror"), lines},
      {"a string wrapped behind a blank", replaced(byHand, "plane mirror", "plane \nmirror"), lines},
      {"a string wrapped and indented", replaced(byHand, "plane mirror", "plane\r\n    mirror"), lines},
      {"a number in two", replaced(byHand, "2.25", "2.\n25"), lines},
      {"a word in two", replaced(byHand, "-9", "-\n9"), lines},
      {"quoted and wrapped then",
       replaced(quoted(byHand, "> "), "plane mirror", "plane\nmirror"),
       {.quoting = true, .lineEnds = true}},
      {"a mark that is the level's", replaced(byHand, "plane mirror", "plane\n> mirror"), lines},
  };
  const Level level = parseLevel(byHand, "by hand").level;
  for (const GoodText& good : table) {
    SCOPED_TRACE(good.what);
    Level expected = level;
    if (std::string(good.what) == "a mark that is the level's") {
      expected.text.edit([](LevelText& text) { text.title = "The plane > mirror"; });
    }
    try {
      const SentLevel sent = readSentLevel(good.text, "the text");
      EXPECT_EQ(sent.level, expected);
      EXPECT_EQ(sent.mends, good.mends);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what() << "\n" << good.text;
    }
  }
}

struct BadText {
  std::string text;
  const char* message;
};

TEST(SentLevel, ABadTextIsToldWhatIsWrong) {
  const char* const withoutOne =
      "the text: expected a level, {\"format\": \"anamorph-level\", ...}, got a text without one";
  const char* const cutOff =
      "the text: expected a whole level, got one that ends before its last brace: it was cut off";
  const BadText table[] = {
      {"", "the text: expected a level, got nothing"},
      {" \r\n\t", "the text: expected a level, got nothing"},
      {"Hello", withoutOne},
      {"[1]", withoutOne},
      {"{", withoutOne},
      {"}}}", withoutOne},
      {"Dear {Jan}", withoutOne},
      {byHand.substr(0, byHand.size() / 2), cutOff},
      {"Hello\n" + quoted(byHand.substr(0, byHand.size() - 1), "> ") + "\nAda", cutOff},
      {"{}",
       "the text: expected a level (with \"format\": \"anamorph-level\") or a scene of the thesis (with "
       "\"Eye\" "
       "and \"Objects\"), got neither"},
      {"{\"format\": \"anamorph-level\"}",
       "the text: expected the key \"version\", got an object without it"},
      {replaced(byHand, "\"radius\": 2", "\"radius\": -2"),
       "the text: /optic/shape/radius: expected a number from 0.000001 to 1000000, got -2"},
      {replaced(byHand, "2.25", "2. 25"),
       "the text: line 2, column 76: syntax error while parsing value - invalid number; expected digit after "
       "'.'; last read: '2. '"},
      {std::string(maxLevelBytes + 1, 'x'), "the text: expected at most 16 MiB, got 16777217 bytes"},
  };
  for (const BadText& bad : table) {
    EXPECT_EQ(withoutPlaces(errorOf([&] { readSentLevel(bad.text, "the text"); })), bad.message)
        << bad.text.substr(0, 200);
  }
}

TEST(SentLevel, AMeshInsideHasALimit) {
  Level level;
  level.original.shape = FileShape{"a.obj", std::string(limits::mostInsideBytes, 'v')};
  EXPECT_EQ(readSentLevel(formatSentLevel(level), "the text").level, level);
  level.original.shape = FileShape{"a.obj", std::string(limits::mostInsideBytes + 1, 'v')};
  EXPECT_EQ(withoutPlaces(errorOf([&] { readSentLevel(formatSentLevel(level), "the text"); })),
            "the text: /original/shape/obj: expected at most 200000 bytes, got 200001");
}

TEST(SentLevel, IsOneLineOfPlainTextWithoutBlanksInStrings) {
  const std::string text = formatSentLevel(titled("a > é 🙂 b\n"));
  EXPECT_NE(text.find("\"a\\u0020\\u003e\\u0020\\u00e9\\u0020\\ud83d\\ude42\\u0020b\\n\""), std::string::npos)
      << text;
  for (const char c : text) EXPECT_TRUE(c >= ' ' && c < 127) << int(c);
}

// As the mailers of the world do it, all at once.
class Mailer {
 public:
  explicit Mailer(unsigned seed) : random_(seed) {}

  std::string send(std::string text) {
    text = wrapped(text);
    if (coin()) text = "```\n" + text + "\n```";
    if (coin()) text = "Hello \"Jan\"; {this} is it:-{\n\n" + text;
    if (coin()) text += "\n-- \nAda }";
    for (int i = below(3); i > 0; --i) text = quoted(text, coin() ? "> " : ">");
    if (coin()) text = "On Monday you {all} wrote:\n" + text;
    return text;
  }

 private:
  // Lines of any length; a blank at a line's end may go, or one may be put there.
  std::string wrapped(const std::string& text) {
    std::string lines;
    const std::string end = coin() ? "\r\n" : "\n";
    const int width = 2 + below(90);
    for (std::size_t i = 0; i < text.size();) {
      const std::size_t length = 1 + static_cast<std::size_t>(below(width));
      lines += text.substr(i, length);
      i += length;
      if (lines.back() == ' ' && coin()) lines.pop_back();
      if (i < text.size()) lines += (below(4) == 0 ? " " : "") + end;
    }
    return lines;
  }
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }
  bool coin() { return below(2) == 1; }

  std::mt19937 random_;
};

TEST(SentLevel, RandomLevelsComeBackWhateverMailersDo) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Level level = RandomLevel(seed).make();
    if (seed % 5 == 0)
      level.original.shape = FileShape{"knot 1.obj", std::string("v 0 -0.5 1e-9\n# > \"{ \\\n")};
    const std::string text = Mailer(seed).send(formatSentLevel(level));
    const std::string error =
        errorOf([&] { EXPECT_EQ(readSentLevel(text, "the text").level, level) << text; });
    ASSERT_EQ(error, "no error") << text;
  }
}

}  // namespace
}  // namespace anamorph
