#include "app/languages.h"

#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/program.h"
#include "error_text.h"

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

TEST_F(LanguageChoiceTest, AnUnknownOneIsAnErrorAndChangesNothing) {
  chooseLanguage("nl");
  EXPECT_THROW(chooseLanguage("xx"), Error);
  EXPECT_STREQ(tr("File"), "Bestand");
}

}  // namespace
}  // namespace anamorph
