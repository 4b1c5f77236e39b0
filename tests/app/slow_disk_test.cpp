// The real window and a disk that does not answer (slow_disk.cpp): it goes on, and it ends when it is asked to.

#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "level/level_json.h"
#include "window_fixture.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

// What a user waits for is half a second; a busy machine's events and frames come on top.
constexpr double quitSeconds = 0.5, slack = 0.4;

class RealWindowSlowDisk : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    fs::create_directories(home("slow-disk"));
    Level level = loadLevel(fs::path(ANAMORPH_LEVELS) / "1-plane.json").level;
    std::get<BoxShape>(level.original.shape).segments = 4;
    saveLevel(home("mine.json"), level);
    level.text.edit([](LevelText& text) { text.title = "Far away"; });
    saveLevel(home("slow-disk/far.json"), level);
    fs::copy_file(std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj", home("slow-disk/cube.obj"));
    level.original.shape = FileShape{"slow-disk/cube.obj"};
    saveLevel(home("far-mesh.json"), level);
  }

  std::string home(const std::string& name) const { return folder / name; }

  void start(const std::string& level, int slowSeconds, const std::string& stateFolder = "state") {
    window = std::make_unique<VirtualWindow>(
        std::vector<std::string>{level, "--size", "1000x700", "--ui-scale", "1"},
        Environment{{"HOME", home("")},
                    {"XDG_STATE_HOME", home(stateFolder)},
                    {"XDG_CONFIG_HOME", home("config")},
                    {"LD_PRELOAD", ANAMORPH_SLOW_DISK},
                    {"ASAN_OPTIONS", "verify_asan_link_order=0:detect_leaks=0"},
                    {"ANAMORPH_SLOW_SECONDS", std::to_string(slowSeconds)}});
    ASSERT_TRUE(window->waitFor([](const State& s) { return s.number("frame") > 5; })) << window->errorText();
    window->move(5, 690);
  }
  void open(const std::string& name) {
    window->key("ctrl+o");
    ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog") == "browser"; }, 20));
    window->type(name);
    window->key("Return");
  }
  // Over the file that is there, if one is.
  void saveAs(const std::string& name) {
    window->key("ctrl+shift+s");
    ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog") == "browser"; }, 20));
    window->type(home(name));
    window->key("Return");
    if (fs::exists(home(name))) window->key("Return");  // replace it
  }
  void expectFrames() {
    const double frame = window->state().number("frame");
    window->key("F1");
    EXPECT_TRUE(window->waitFor([](const State& s) { return s.is("helpOpen"); }, 3))
        << "the window is frozen";
    EXPECT_GT(window->state().number("frame"), frame);
    window->key("F1");
  }
  void expectQuickEnd() {
    window->askToClose();
    expectEndNow();
  }
  void expectEndNow() {
    const double asked = secondsOfClock();
    EXPECT_TRUE(window->program().waitForEnd(20));
    EXPECT_LT(secondsOfClock() - asked, quitSeconds + slack);
    EXPECT_EQ(window->program().exitCode(), 0) << window->errorText();
  }

  TemporaryFolder folder;
};

TEST_F(RealWindowSlowDisk, AMeshThatDoesNotComeHoldsNothingUp) {
  start(home("far-mesh.json"), 60);
  ASSERT_FALSE(window->state().is("complete"));
  expectFrames();
  expectQuickEnd();
}

TEST_F(RealWindowSlowDisk, AnotherLevelCanBeOpenedMeanwhile) {
  start(home("far-mesh.json"), 60);
  open("mine.json");
  EXPECT_TRUE(window->waitFor(
      [](const State& s) { return s.text("level").ends_with("mine.json") && s.is("complete"); }, 20))
      << "its sculpture is made, whatever still hangs";
  expectQuickEnd();
}

TEST_F(RealWindowSlowDisk, ALevelThatDoesNotComeHoldsNothingUp) {
  start(home("mine.json"), 60);
  open("slow-disk/far.json");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("opening"); }, 5));
  expectFrames();
  EXPECT_TRUE(window->state().text("level").ends_with("mine.json"));
  expectQuickEnd();
}

TEST_F(RealWindowSlowDisk, WhatComesLateIsOpened) {
  start(home("mine.json"), 1);
  open("slow-disk/far.json");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("opening"); }, 5));
  EXPECT_TRUE(window->waitFor([](const State& s) { return s.text("title").starts_with("Far away"); }, 20));
  EXPECT_FALSE(window->state().is("opening"));
  expectQuickEnd();
}

TEST_F(RealWindowSlowDisk, ALevelThatIsNotWrittenInTimeHoldsNothingUpAndIsReported) {
  start(home("mine.json"), 60);
  ASSERT_TRUE(window->settle());
  saveAs("slow-disk/far.json");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("saving"); }, 5));
  expectFrames();
  EXPECT_TRUE(window->state().text("level").ends_with("mine.json"));
  window->askToClose();
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog") == "finish"; }));
  window->key("s");  // stop and quit
  expectEndNow();
  EXPECT_THAT(window->errorText(),
              HasSubstr("slow-disk/far.json: was not written: the window was closed before"));
  EXPECT_EQ(loadLevel(home("slow-disk/far.json")).level.text->title, "Far away") << "the old file stays";
}

TEST_F(RealWindowSlowDisk, ALevelThatIsWrittenLateIsSavedThen) {
  start(home("mine.json"), 1);
  ASSERT_TRUE(window->settle());
  saveAs("slow-disk/new.json");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("saving"); }, 5));
  EXPECT_TRUE(window->waitFor([](const State& s) { return s.text("level").ends_with("new.json"); }, 20));
  EXPECT_FALSE(window->state().is("saving"));
  expectQuickEnd();
  EXPECT_TRUE(fs::exists(home("slow-disk/new.json")));
}

TEST_F(RealWindowSlowDisk, AnExportThatCannotBeWrittenInTimeIsReported) {
  start(home("mine.json"), 60);
  ASSERT_TRUE(window->settle());
  window->key("ctrl+e");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("exporting"); }, 20));
  window->key("Return");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog") == "browser"; }, 20));
  window->type(home("slow-disk/s.stl"));
  window->key("Return");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog").empty(); }, 20));
  sleepFor(0.3);
  window->askToClose();
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog") == "finish"; }));
  window->key("s");  // stop and quit
  expectEndNow();
  EXPECT_THAT(window->errorText(),
              HasSubstr("slow-disk/s.stl: was not written: the window was closed before"));
  EXPECT_FALSE(fs::exists(home("slow-disk/s.stl")));
}

TEST_F(RealWindowSlowDisk, WhatWasRescuedDoesNotWaitForItsFile) {
  fs::create_directories(home("state/anamorph"));
  writeText(home("state/anamorph/recovery-1.json"),
            "{\"format\": \"anamorph-recovery\", \"path\": \"" + home("slow-disk/far.json") +
                "\", \"time\": 1700000000, \"fileTime\": \"\", \"level\": " + readAll(home("mine.json")) +
                "}");
  start(home("mine.json"), 60);
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("dialog") == "recovery"; }, 20));
  window->key("Return");
  const double frame = window->state().number("frame");
  EXPECT_TRUE(window->waitFor([&](const State& s) { return s.number("frame") > frame + 5; }, 3)) << "frozen";
  EXPECT_TRUE(window->waitFor([](const State& s) { return s.text("level").ends_with("far.json"); }, 15));
  EXPECT_TRUE(window->state().is("modified"));
}

TEST_F(RealWindowSlowDisk, WhatIsKeptForTheNextStartHoldsNothingUpEither) {
  start(home("mine.json"), 60, "slow-disk/state");
  ASSERT_TRUE(window->settle());
  expectFrames();
  expectQuickEnd();
  EXPECT_THAT(window->errorText(), HasSubstr("slow-disk/state/anamorph/recent.json: was not written"));
}

TEST_F(RealWindowSlowDisk, WithNothingToDoItEndsAsQuickly) {
  start(home("mine.json"), 60);
  ASSERT_TRUE(window->settle());
  expectQuickEnd();
  EXPECT_EQ(window->errorText(), "");
}

}  // namespace
}  // namespace anamorph::testing
