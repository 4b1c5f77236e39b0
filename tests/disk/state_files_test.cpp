// What the window keeps outlives a power cut at any moment: preferences, progress, recent files, unsaved changes.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/autosave.h"
#include "app/preferences.h"
#include "app/progress_file.h"
#include "app/state_folder.h"
#include "base/file.h"
#include "disk/power_cut.h"
#include "level/level_json.h"
#include "save_session.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using namespace testing;

// Whoever left out one of the two flushes would lose it.
template <typename MakeSteps>
void expectOutlives(const MakeSteps& makeSteps, const Document& document) {
  EXPECT_EQ(cutPower(makeSteps(), document).fault, "");
  EXPECT_NE(cutPower(makeSteps(), document, DiskChange::sync).fault, "");
  EXPECT_NE(cutPower(makeSteps(), document, DiskChange::syncFolder).fault, "");
}

TEST(StateFiles, PreferencesOutliveAPowerCut) {
  const auto save = [](const char* language) {
    return [=](const fs::path& folder) {
      Preferences preferences;
      preferences.language = language;
      savePreferences(folder / "config/preferences.json", {}, preferences);
    };
  };
  const Document language = [](const fs::path& folder) {
    std::string message;
    const Preferences preferences = loadPreferences(folder / "config/preferences.json", message);
    if (!message.empty()) throw std::runtime_error(message);
    return preferences.language;
  };
  expectOutlives([&] { return std::vector<Step>{save("nl"), save("en")}; }, language);
}

std::string stepsIn(const fs::path& file) {
  std::string message, text;
  for (const auto& [lesson, done] : loadProgress(file, message)) {
    for (const std::string& step : done) text += lesson + "/" + step + " ";
  }
  return message.empty() ? text : "broken";
}

TEST(StateFiles, ProgressOutlivesAPowerCut) {
  const auto save = [](const char* step) {
    return [=](const fs::path& folder) { saveProgress(folder / "progress.json", {}, {{"plane", {step}}}); };
  };
  const Document done = [](const fs::path& folder) { return stepsIn(folder / "progress.json"); };
  expectOutlives([&] { return std::vector<Step>{save("a"), save("b")}; }, done);
}

TEST(StateFiles, ProgressThatIsBrokenIsKeptThroughAPowerCut) {
  const std::string broken = "{ mine";
  const Step breaks = [&](const fs::path& folder) { writeFile(folder / "progress.json", broken); };
  const Step saves = [](const fs::path& folder) {
    saveProgress(folder / "progress.json", {}, {{"x", {"y"}}});
  };
  const Document kept = [&](const fs::path& folder) {
    for (const char* name : {"progress.json.broken", "progress.json"}) {
      if (fs::exists(folder / name) && readFile(folder / name, 1000).view() == broken) return "kept";
    }
    return "none";
  };
  expectOutlives([&] { return std::vector<Step>{breaks, saves}; }, kept);
}

TEST(StateFiles, RecentFilesOutliveAPowerCut) {
  const auto save = [](const char* level) {
    return [=](const fs::path& folder) { saveRecent(folder / "state", {{level}, {}}); };
  };
  const Document recent = [](const fs::path& folder) {
    std::string text;
    for (const fs::path& level : loadRecent(folder / "state").levels) text += level.string() + " ";
    return text;
  };
  expectOutlives([&] { return std::vector<Step>{save("/a"), save("/b")}; }, recent);
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

// A window that keeps what it edits and what it has left, and ends once it is saved.
struct Window {
  Session session;
  Autosave::LeftLevels left;
  std::optional<Autosave> autosave;
  double clock = 1000;

  Window() { session.startNew(numbered(0)); }
  void update(const fs::path& folder) {
    if (!autosave) autosave.emplace(folder / "state");
    for (int i = 0; i < 2; ++i) {  // it is seen, it is due
      ASSERT_EQ(autosave->update(session, left, clock += 10), std::nullopt);
      ASSERT_TRUE(autosave->finish(20));
    }
  }
  void keep(int number, const fs::path& folder) {
    session.edit(numbered(number));
    update(folder);
  }
  void leave(int number, const fs::path& folder) {
    left = {{"/levels/a.json", numbered(number)}};
    update(folder);
  }
  void saveAndEnd(const fs::path& folder) {
    testing::saveTo(session, folder / "mine.json");
    autosave.reset();
  }
};

// The file of the unsaved changes goes only when the level's own file has them for good.
TEST(StateFiles, UnsavedChangesOutliveAPowerCut) {
  const auto steps = [] {
    const auto window = std::make_shared<Window>();
    return std::vector<Step>{[=](const fs::path& folder) { window->keep(1, folder); },
                             [=](const fs::path& folder) { window->keep(2, folder); },
                             [=](const fs::path& folder) { window->saveAndEnd(folder); }};
  };
  expectOutlives(steps, newest);
}

TEST(StateFiles, LevelsThatWereLeftOutliveAPowerCut) {
  const auto steps = [] {
    const auto window = std::make_shared<Window>();
    return std::vector<Step>{[=](const fs::path& folder) { window->leave(1, folder); },
                             [=](const fs::path& folder) { window->leave(2, folder); }};
  };
  expectOutlives(steps, newest);
}

}  // namespace
}  // namespace anamorph
