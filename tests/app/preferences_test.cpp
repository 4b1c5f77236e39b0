#include "app/preferences.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/program.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;
using ::testing::HasSubstr;

Preferences load(const std::string& path, std::string* said = nullptr) {
  std::string message;
  const Preferences preferences = loadPreferences(path, message);
  if (said) *said = message;
  return preferences;
}

TEST(PreferencesFile, RoundTrip) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  Preferences before;
  for (const Theme theme : {Theme::dark, Theme::light, Theme::projector}) {
    for (const double scale : {0.0, 0.75, 1.1, 2.5, 3.0}) {
      for (const bool flag : {false, true}) {
        const Preferences p{theme, scale, flag, !flag, flag, 300, 500, 700, flag ? "nl" : ""};
        savePreferences(path, std::exchange(before, p), p);
        std::string message = "untouched";
        EXPECT_EQ(loadPreferences(path, message), p);
        EXPECT_EQ(message, "untouched");
      }
    }
  }
  EXPECT_EQ(folder.fileCount(), 1u) << "nothing is left beside it";
}

TEST(PreferencesFile, WithoutOneAllIsDefault) {
  const TemporaryFolder folder;
  std::string message;
  EXPECT_EQ(load(folder / "none.json", &message), Preferences());
  EXPECT_EQ(load(folder / "no/folder/none.json", &message), Preferences());
  EXPECT_EQ(message, "");
}

TEST(PreferencesFile, BrokenOnesKeepTheDefaultsAndSayWhatIsWrong) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  for (const char* text :
       {"", "{", "nonsense", "{\"theme\": \"light\",}", "{\"theme\": \"light\", \"theme\": \"dark\"}",
        "{\"uiScale\": NaN}", "\xff\xfe", "{\"uiScale\": 1e999}"}) {
    SCOPED_TRACE(text);
    writeText(path, text);
    std::string message;
    EXPECT_EQ(load(path, &message), Preferences());
    EXPECT_THAT(message, HasSubstr(path));
    EXPECT_EQ(message.find('\n'), std::string::npos) << "one line";
    EXPECT_EQ(readAll(path), text) << "the user's file stays as it is";
  }
}

TEST(PreferencesFile, WhatMakesNoSenseHasItsDefault) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  for (const char* text :
       {"[]", "3", "null", "{\"theme\": \"pink\"}", "{\"theme\": 3}", "{\"uiScale\": \"large\"}",
        "{\"legend\": 1}", "{\"vrtKeys\": null}", "{\"leftWidth\": []}", "{\"unknown\": {\"a\": [1]}}"}) {
    SCOPED_TRACE(text);
    writeText(path, text);
    EXPECT_EQ(load(path), Preferences());
  }
}

TEST(PreferencesFile, AWrongThemeIsTold) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  writeText(path, R"({"theme": "pink", "uiScale": 2})");
  std::string message;
  const Preferences preferences = load(path, &message);
  EXPECT_EQ(preferences.theme, Theme::dark);
  EXPECT_EQ(preferences.uiScale, 2) << "the rest is taken";
  EXPECT_THAT(message, HasSubstr("pink"));
}

TEST(PreferencesFile, NumbersAreKeptWithinReason) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  writeText(path, R"({"uiScale": 1e300, "leftWidth": -5, "rightWidth": 1e9, "previewHeight": 0})");
  const Preferences most = load(path);
  EXPECT_EQ(most.uiScale, 3);
  EXPECT_EQ(most.leftWidth, 180);
  EXPECT_EQ(most.rightWidth, 900);
  EXPECT_EQ(most.previewHeight, 220);
  writeText(path, R"({"uiScale": 0.001})");
  EXPECT_EQ(load(path).uiScale, 0.75);
  writeText(path, R"({"uiScale": -1})");
  EXPECT_EQ(load(path).uiScale, 0) << "as the screen says";
}

TEST(PreferencesFile, OfTwoWindowsKeepsWhatEachHasChanged) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  savePreferences(path, {}, {});
  Preferences light, dutch, narrow;
  light.theme = Theme::light;
  dutch.language = "nl";
  savePreferences(path, {}, light);
  savePreferences(path, {}, dutch);  // a window that knows nothing of the other
  narrow = light;
  narrow.leftWidth = 200;
  savePreferences(path, light, narrow);
  const Preferences all = load(path);
  EXPECT_EQ(all.theme, Theme::light);
  EXPECT_EQ(all.language, "nl");
  EXPECT_EQ(all.leftWidth, 200);
}

TEST(PreferencesFile, KeepsWhatANewerProgramHasWritten) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  writeText(path, R"({"colours": {"grid": "red"}, "legend": true})");
  Preferences changed;
  changed.legend = false;
  savePreferences(path, {}, changed);
  EXPECT_THAT(readAll(path), HasSubstr("\"grid\": \"red\""));
  EXPECT_EQ(load(path), changed);
}

TEST(PreferencesFile, IsReplacedAtomically) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  savePreferences(path, {}, {});
  struct stat before {};
  ASSERT_EQ(stat(path.c_str(), &before), 0);
  const std::filesystem::path link = folder / "old";
  std::filesystem::create_hard_link(path, link);  // keeps the old file's number from being used again
  const std::string old = readAll(path);
  Preferences changed;
  changed.theme = Theme::light;
  savePreferences(path, {}, changed);
  struct stat after {};
  ASSERT_EQ(stat(path.c_str(), &after), 0);
  EXPECT_NE(before.st_ino, after.st_ino) << "another file in its place, not the same one written over";
  EXPECT_EQ(readAll(link.string()), old);
  EXPECT_EQ(load(path), changed);
}

TEST(PreferencesFile, FailuresAreErrorsAndCostNothing) {
  const TemporaryFolder folder;
  const std::string path = folder / "preferences.json";
  writeText(folder / "file", "");
  EXPECT_THROW(savePreferences(folder / "file/below/preferences.json", {}, {}), Error);
  if (::getuid() == 0) GTEST_SKIP() << "root may write everywhere";
  savePreferences(path, {}, {});
  const std::string old = readAll(path);
  ::chmod((folder / "").c_str(), 0500);
  Preferences changed;
  changed.legend = false;
  EXPECT_THROW(savePreferences(path, {}, changed), Error);
  ::chmod((folder / "").c_str(), 0700);
  EXPECT_EQ(readAll(path), old);
}

TEST(PreferencesFile, MakesItsFolders) {
  const TemporaryFolder folder;
  const std::string path = folder / "a/b/preferences.json";
  savePreferences(path, {}, {});
  EXPECT_EQ(load(path), Preferences());
}

TEST(PreferencesPath, FollowsTheEnvironment) {
  const char* const config = std::getenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  const std::string oldConfig = config ? config : "", oldHome = home ? home : "";
  ::setenv("XDG_CONFIG_HOME", "/somewhere", 1);
  ::setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(preferencesPath(), "/somewhere/anamorph/preferences.json");
  ::setenv("XDG_CONFIG_HOME", "", 1);
  EXPECT_EQ(preferencesPath(), "/home/somebody/.config/anamorph/preferences.json");
  ::unsetenv("XDG_CONFIG_HOME");
  EXPECT_EQ(preferencesPath(), "/home/somebody/.config/anamorph/preferences.json");
  config ? ::setenv("XDG_CONFIG_HOME", oldConfig.c_str(), 1) : ::unsetenv("XDG_CONFIG_HOME");
  home ? ::setenv("HOME", oldHome.c_str(), 1) : ::unsetenv("HOME");
}

TEST(Themes, HaveNames) {
  for (const Theme theme : {Theme::dark, Theme::light, Theme::projector})
    EXPECT_EQ(findTheme(themeName(theme)), theme);
  EXPECT_EQ(findTheme("pink"), std::nullopt);
  EXPECT_EQ(findTheme(""), std::nullopt);
}

}  // namespace
}  // namespace anamorph
