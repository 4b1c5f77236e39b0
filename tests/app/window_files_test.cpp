// Files in the real window: opening, saving, being asked, and what is left when the program is killed.

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/autosave.h"
#include "level/level_json.h"
#include "window_fixture.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// A small level, so that frames are quick.
Level smallLevel() {
  Level level = loadLevel(fs::path(ANAMORPH_LEVELS) / "1-plane.json").level;
  level.text.edit([&](LevelText& text) { text.title = "Small"; });
  std::get<BoxShape>(level.original.shape).segments = 4;
  return level;
}

class RealWindowFiles : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    fs::create_directories(home("works"));
    saveLevel(home("works/mine.json"), smallLevel());
    Level other = smallLevel();
    other.text.edit([&](LevelText& text) { text.title = "Other"; });
    saveLevel(home("works/other.json"), other);
  }

  std::string home(const std::string& name) const { return folder / name; }

  void start(const std::string& level, std::vector<std::string> more = {}) {
    window.reset();
    more.insert(more.begin(), level);
    more.insert(more.end(), {"--size", "1000x700", "--ui-scale", "1"});
    window = std::make_unique<VirtualWindow>(more, Environment{{"HOME", home("")},
                                                               {"XDG_STATE_HOME", home("state")},
                                                               {"XDG_CONFIG_HOME", home("config")}});
    ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("complete"); })) << window->errorText();
    window->move(5, 690);
  }
  State state() const { return window->state(); }

  // Drags the eye's x in the properties; `release`: or keeps the button down.
  void dragEye(bool release = true) {
    const auto list = state().list("properties");
    const double x = list.at(0) + 0.46 * list.at(2);
    const Vector before = state().vector("eye");
    for (double y = list.at(1) + 106; y < list.at(1) + 120; y += 6) {
      window->move(x, y);
      window->press();
      window->move(x + 25, y);
      if (state().vector("eye") != before) break;
      window->release();
    }
    ASSERT_NE(state().vector("eye"), before);
    if (!release) return;
    window->release();
    ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("changing"); }));
  }
  bool waitForDialog(const std::string& name) {
    return window->waitFor([&](const State& s) { return s.text("dialog") == name; });
  }
  std::vector<fs::path> recoveries() const {
    std::vector<fs::path> files;
    std::error_code none;
    for (fs::directory_iterator entry(home("state/anamorph"), none), end; !none && entry != end;
         entry.increment(none)) {
      const std::string name = entry->path().filename().string();
      if (name.starts_with("recovery-") && entry->path().extension() == ".json")
        files.push_back(entry->path());
    }
    return files;
  }
  void kill(int signal = SIGKILL) {
    ::kill(window->program().pid(), signal);
    ASSERT_TRUE(window->program().waitForEnd());
    EXPECT_EQ(window->program().exitCode(), -signal);
  }

  TemporaryFolder folder;
};

TEST_F(RealWindowFiles, ALevelIsOpenedChangedSavedAndUndone) {
  start("1-plane");
  window->key("ctrl+o");
  ASSERT_TRUE(waitForDialog("browser"));
  window->type("works/mi");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("typed") == "mi"; }))
      << state().text("typed");
  window->key("Return");
  ASSERT_TRUE(
      window->waitFor([](const State& s) { return s.text("title") == "Small (mine.json) - Anamorph"; }));
  const Vector before = state().vector("eye");
  dragEye();
  ASSERT_TRUE(
      window->waitFor([](const State& s) { return s.text("title") == "Small (mine.json) * - Anamorph"; }));
  window->key("ctrl+s");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("modified"); }));
  EXPECT_EQ(loadLevel(home("works/mine.json")).level.camera.eye, state().vector("eye"));
  window->key("ctrl+z");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("modified"); })) << "undone beyond the saving";
  EXPECT_EQ(state().vector("eye"), before);
  EXPECT_THAT(readAll(home("state/anamorph/recent.json")), HasSubstr("mine.json"));
  window->key("ctrl+y");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("modified"); }));
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(window->program().exitCode(), 0);
  EXPECT_TRUE(recoveries().empty());
}

TEST_F(RealWindowFiles, ClosingWithChangesAsks) {
  start(home("works/mine.json"));
  dragEye();
  window->askToClose();
  ASSERT_TRUE(waitForDialog("unsaved"));
  window->key("Escape");
  ASSERT_TRUE(waitForDialog(""));
  EXPECT_FALSE(window->program().ended());
  window->askToClose();
  ASSERT_TRUE(waitForDialog("unsaved"));
  window->key("Return");
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(window->program().exitCode(), 0);
  EXPECT_NE(loadLevel(home("works/mine.json")).level, smallLevel()) << "saved, then closed";
}

TEST_F(RealWindowFiles, ClosingWithoutSavingLeavesFileAndNoTraces) {
  start(home("works/mine.json"));
  dragEye();
  window->key("ctrl+q");
  ASSERT_TRUE(waitForDialog("unsaved"));
  window->key("d");
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(loadLevel(home("works/mine.json")).level, smallLevel());
  EXPECT_TRUE(recoveries().empty());
}

TEST_F(RealWindowFiles, KilledInADragOffersWhatItWasTenSecondsAgoOrLater) {
  start(home("works/mine.json"));
  const Vector before = state().vector("eye");
  const auto dragged = [&](const Vector& eye) { return glm::length(eye - before); };
  dragEye(false);
  std::vector<std::pair<double, double>> way{{secondsOfClock(), dragged(state().vector("eye"))}};
  while (secondsOfClock() < way.front().first + 11) {
    window->moveBy(2, 0);
    sleepFor(0.3);
    way.emplace_back(secondsOfClock(), dragged(state().vector("eye")));
  }
  const double tenSecondsAgo = secondsOfClock() - 10;
  ASSERT_TRUE(state().is("changing"));
  kill();
  ASSERT_EQ(recoveries().size(), 1u);
  EXPECT_EQ(loadLevel(home("works/mine.json")).level, smallLevel()) << "the file is as it was saved";

  start("1-plane");
  ASSERT_TRUE(waitForDialog("recovery"));
  window->key("Escape");  // decide later
  ASSERT_TRUE(waitForDialog(""));
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  ASSERT_EQ(recoveries().size(), 1u);

  start("1-plane");
  ASSERT_TRUE(waitForDialog("recovery"));
  window->key("Return");
  ASSERT_TRUE(
      window->waitFor([](const State& s) { return s.text("title") == "Small (mine.json) * - Anamorph"; }));
  const Vector kept = state().vector("eye");
  const auto later =
      std::find_if(way.begin(), way.end(), [&](const auto& place) { return place.first > tenSecondsAgo; });
  EXPECT_GE(dragged(kept), std::prev(later)->second);
  EXPECT_EQ(recoveries().size(), 1u) << "it is kept until it is saved";
  window->key("ctrl+s");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("modified"); }));
  EXPECT_EQ(loadLevel(home("works/mine.json")).level.camera.eye, kept);
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_TRUE(recoveries().empty());
}

TEST_F(RealWindowFiles, KilledAfterSavingOffersNothing) {
  start(home("works/mine.json"));
  dragEye();
  sleepFor(Autosave::gatherSeconds + Autosave::leastSeconds + 1);
  ASSERT_EQ(recoveries().size(), 1u);
  const std::string older = readAll(recoveries().front());
  window->key("ctrl+s");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("modified"); }));
  kill();
  writeText(home("state/anamorph/recovery-1.json"), older);  // as if it had come between saving and removing
  start("1-plane");
  sleepFor(0.5);
  EXPECT_EQ(state().text("dialog"), "");
  EXPECT_TRUE(recoveries().empty());
}

TEST_F(RealWindowFiles, SaysByItselfThatChangesCannotBeKept) {
  constexpr double kept = Autosave::gatherSeconds + Autosave::leastSeconds + 1;
  start(home("works/mine.json"));
  dragEye();
  sleepFor(kept);
  ASSERT_EQ(recoveries().size(), 1u);
  const fs::path file = recoveries().front();
  fs::remove(file);
  fs::create_directory(file);
  dragEye();
  const auto isSaid = [](const State& s) {
    return s.text("message").find("could not be kept") != std::string::npos;
  };
  ASSERT_TRUE(window->waitFor(isSaid, kept)) << "no mouse, no key: " << state().text("message");
  const double frame = state().number("frame");
  EXPECT_TRUE(window->waitFor([&](const State& s) { return s.number("frame") > frame; }, 2)) << "it is drawn";
}

TEST_F(RealWindowFiles, WithoutAFolderForItsStateWorkOn) {
  writeText(home("state"), "a file in the folder's place");
  start(home("works/mine.json"), {std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj"});
  ASSERT_TRUE(window->waitFor([](const State& s) {
    return s.is("modified") && s.text("message").find("could not be kept") != std::string::npos;
  })) << state().text("message");
  window->key("ctrl+s");
  EXPECT_TRUE(window->waitFor([](const State& s) { return !s.is("modified"); }));
  window->askToClose();
  EXPECT_TRUE(window->program().waitForEnd(20));
  EXPECT_EQ(window->program().exitCode(), 0);
}

// An assertion of a library ends the program this way, long before unsaved changes are due on disk.
TEST_F(RealWindowFiles, AbortedRightAfterAnEditOffersIt) {
  start(home("works/mine.json"));
  dragEye();
  const Vector edited = state().vector("eye");
  kill(SIGABRT);
  EXPECT_EQ(recoveries().size(), 1u);
  start("1-plane");
  ASSERT_TRUE(waitForDialog("recovery"));
  window->key("Return");
  ASSERT_TRUE(
      window->waitFor([](const State& s) { return s.text("title") == "Small (mine.json) * - Anamorph"; }));
  EXPECT_EQ(state().vector("eye"), edited);
}

TEST_F(RealWindowFiles, ARecoveryThatFailsStaysAndSaysWhy) {
  fs::create_directories(home("state/anamorph"));
  writeText(home("state/anamorph/recovery-1.json"), "{\"format\": \"anamorph-recovery\", \"le");
  start("1-plane");
  ASSERT_TRUE(waitForDialog("recovery"));
  window->key("Return");
  EXPECT_EQ(state().text("dialog"), "recovery") << "it cannot be restored";
  window->key("Escape");
  ASSERT_TRUE(waitForDialog(""));
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(recoveries().size(), 1u);
}

TEST_F(RealWindowFiles, AModelIsNamedOnTheCommandLine) {
  start(home("works/mine.json"), {std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj"});
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("modified") && s.is("complete"); }));
  EXPECT_EQ(state().text("problem"), "");
  window->key("ctrl+z");
  EXPECT_TRUE(window->waitFor([](const State& s) { return !s.is("modified"); }));
}

}  // namespace
}  // namespace anamorph::testing
