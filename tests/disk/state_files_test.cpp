// What the window keeps outlives a power cut at any moment: preferences, progress, recent files, unsaved changes.

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "app/autosave.h"
#include "app/preferences.h"
#include "app/progress_file.h"
#include "app/state_folder.h"
#include "base/file.h"
#include "disk/power_cut.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

TEST(StateFiles, PreferencesOutliveAPowerCut) {
  const auto save = [](const char* language) {
    return [=](const fs::path& folder) {
      Preferences preferences;
      preferences.language = language;
      savePreferences(folder / "config/preferences.json", preferences);
    };
  };
  const Document language = [](const fs::path& folder) {
    std::string message;
    const Preferences preferences = loadPreferences(folder / "config/preferences.json", message);
    if (!message.empty()) throw std::runtime_error(message);
    return preferences.language;
  };
  EXPECT_EQ(cutPower({save("nl"), save("en")}, language).fault, "");
}

std::string steps(const fs::path& file) {
  std::string message, text;
  for (const auto& [lesson, done] : loadProgress(file, message)) {
    for (const std::string& step : done) text += lesson + "/" + step + " ";
  }
  return message.empty() ? text : "broken";
}

TEST(StateFiles, ProgressOutlivesAPowerCut) {
  const auto save = [](const char* step) {
    return [=](const fs::path& folder) { saveProgress(folder / "progress.json", {{"plane", {step}}}); };
  };
  const Document done = [](const fs::path& folder) { return steps(folder / "progress.json"); };
  EXPECT_EQ(cutPower({save("a"), save("b")}, done).fault, "");
}

TEST(StateFiles, ProgressThatIsBrokenIsKeptThroughAPowerCut) {
  const Step breaks = [](const fs::path& folder) { writeFile(folder / "progress.json", "{ mine"); };
  const Step saves = [](const fs::path& folder) { saveProgress(folder / "progress.json", {{"x", {"y"}}}); };
  const Document broken = [](const fs::path& folder) {
    for (const char* name : {"progress.json.broken", "progress.json"}) {
      if (fs::exists(folder / name) && steps(folder / name) == "broken") return "kept";
    }
    return "none";
  };
  EXPECT_EQ(cutPower({breaks, saves}, broken).fault, "");
}

TEST(StateFiles, RecentFilesOutliveAPowerCut) {
  const auto save = [](const char* level) {
    return [=](const fs::path& folder) {
      UiState ui;
      ui.recentLevels = {level};
      saveRecent(folder / "state", ui);
    };
  };
  const Document recent = [](const fs::path& folder) {
    UiState ui;
    loadRecent(folder / "state", ui);
    std::string text;
    for (const fs::path& level : ui.recentLevels) text += level.string() + " ";
    return text;
  };
  EXPECT_EQ(cutPower({save("/a"), save("/b")}, recent).fault, "");
}

Level numbered(int number) {
  Level level;
  level.text.edit([&](LevelText& text) { text.title = std::to_string(number); });
  return level;
}

// The newest that is in the level's file or offered by the next start.
std::string newest(const fs::path& folder) {
  std::string title = "0";
  if (fs::exists(folder / "mine.json")) title = loadLevel(folder / "mine.json").level.text->title;
  for (const Rescued& rescued : findRescued(folder / "state")) {
    if (!rescued.entry.problem.empty()) throw std::runtime_error(rescued.entry.problem);
    title = std::max(title, rescued.level.text->title);
  }
  return title;
}

TEST(StateFiles, UnsavedChangesOutliveAPowerCut) {
  Session session;
  session.startNew(numbered(0));
  std::optional<Autosave> autosave;
  const auto keep = [&](int number) {
    return [&, number](const fs::path& folder) {
      if (!autosave) autosave.emplace(folder / "state");
      session.edit(numbered(number));
      autosave->writeNow(session);
    };
  };
  // The file of the unsaved changes goes when the level's own file has them, whatever the disk does first.
  const Step save = [&](const fs::path& folder) {
    session.saveTo(folder / "mine.json");
    autosave.reset();
  };
  EXPECT_EQ(cutPower({keep(1), keep(2), save}, newest).fault, "");
}

TEST(StateFiles, LevelsThatWereLeftOutliveAPowerCut) {
  std::optional<Autosave> autosave;
  const auto keep = [&](int number) {
    return [&, number](const fs::path& folder) {
      if (!autosave) autosave.emplace(folder / "state");
      ASSERT_EQ(autosave->keepLeft({{"/levels/a.json", numbered(number)}}), std::nullopt);
    };
  };
  EXPECT_EQ(cutPower({keep(1), keep(2)}, newest).fault, "");
  autosave.reset();
}

}  // namespace
}  // namespace anamorph
