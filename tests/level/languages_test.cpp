#include "level/languages.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/program.h"
#include "error_text.h"
#include "level/lesson.h"
#include "level/level_json.h"
#include "level/level_library.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

struct BadLanguage {
  const char* name;
  const char* json;
  const char* message;
};

class BadLanguageFile : public ::testing::TestWithParam<BadLanguage> {};

TEST_P(BadLanguageFile, SaysWhatIsWrongAndWhere) {
  const TemporaryFolder folder;
  const std::string path = folder / "xx.json";
  writeFile(path, GetParam().json);
  EXPECT_EQ(errorOf([&] { loadTexts(path); }), path + ": " + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Languages, BadLanguageFile,
    ::testing::Values(
        BadLanguage{"NoFormat", R"({"name": "X", "texts": {}})",
                    "/format: expected \"anamorph-language\", got nothing"},
        BadLanguage{"OtherFormat", R"({"format": "anamorph-level", "texts": {}})",
                    "/format: expected \"anamorph-language\", got \"anamorph-level\""},
        BadLanguage{"NoTexts", R"({"format": "anamorph-language", "name": "X"})",
                    "/texts: expected an object, got nothing"},
        BadLanguage{"Number", R"({"format": "anamorph-language", "texts": {"Save": 3}})",
                    "/texts/Save: expected a string that is not empty, got 3"},
        BadLanguage{"Empty", R"({"format": "anamorph-language", "texts": {"Save": ""}})",
                    "/texts/Save: expected a string that is not empty, got \"\""},
        BadLanguage{"LoneBrace",
                    R"({"format": "anamorph-language", "texts": {"Saved: {}": "Opgeslagen: {} {"}})",
                    "/texts/Saved: {}: expected the same {} places as in English, got \"Opgeslagen: {} {\""},
        BadLanguage{"LoneBraceAlone", R"({"format": "anamorph-language", "texts": {"Save": "}"}})",
                    "/texts/Save: expected the same {} places as in English, got \"}\""},
        BadLanguage{"OtherPlaces", R"({"format": "anamorph-language", "texts": {"{} of {}": "{} uit"}})",
                    "/texts/{} of {}: expected the same {} places as in English, got \"{} uit\""}),
    [](const auto& bad) { return bad.param.name; });

class LanguageChoiceTest : public ::testing::Test {
 protected:
  ~LanguageChoiceTest() override { setLanguage(nullptr); }
};

TEST_F(LanguageChoiceTest, DutchIsInstalledAndChangesTextsAtOnce) {
  const auto languages = listLanguages();
  ASSERT_GE(languages.size(), 2u);
  EXPECT_EQ(languages[0].name, "English");
  EXPECT_EQ(languages[1].name, "Nederlands");
  const std::string english = tr("File");
  chooseLanguage("nl");
  EXPECT_STREQ(tr("File"), "Bestand");
  EXPECT_STREQ(tr("a text that no table has"), "a text that no table has");
  chooseLanguage("en");
  EXPECT_EQ(tr("File"), english);
}

// Every text of the installed levels, with what is needed to find it.
TEST(Dutch, HasEveryTextOfTheLevels) {
  const TextTable texts = loadTexts(ANAMORPH_SOURCE_DIR "/assets/languages/nl.json");
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    const Level level = loadLevel(entry.path).level;
    const Lesson lesson = parseLesson(level.text->lesson, entry.name);
    std::vector<std::string> shown{level.text->title, level.text->description, lesson.badge.title,
                                   lesson.badge.text};
    for (const LessonStep& step : lesson.steps) {
      shown.insert(shown.end(), {step.title, step.why, step.task, step.notice});
      // A step names its control, so that has a Dutch name too.
      if (!step.show.widget.empty()) shown.push_back(step.show.widget);
    }
    for (const std::string& text : shown) {
      EXPECT_EQ(texts.count(text), 1u) << entry.name << ": " << text;
    }
  }
}

TEST_F(LanguageChoiceTest, AnUnknownOneIsAnErrorAndChangesNothing) {
  chooseLanguage("nl");
  EXPECT_THROW(chooseLanguage("xx"), Error);
  EXPECT_STREQ(tr("File"), "Bestand");
}

}  // namespace
}  // namespace anamorph
