// A GUI without a window for the tests of src/app. Machines without OpenGL 3.3 cannot run them.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "app/headless_gui.h"
#include "base/error.h"
#include "cannot_run_here.h"
#include "gl/gl_error.h"

namespace anamorph::testing {

/// Made once for the program. Null, and `problem` says why, when there is none.
inline HeadlessContext* sharedHeadlessContext(std::string& problem) {
  static std::string why;
  static const std::unique_ptr<HeadlessContext> context = [] {
    try {
      return std::make_unique<HeadlessContext>();
    } catch (const Error& error) {
      why = error.what();
      return std::unique_ptr<HeadlessContext>();
    }
  }();
  problem = why;
  return context.get();
}

inline std::string levelPath(const std::string& name) {
  return std::string(ANAMORPH_LEVELS) + "/" + name + ".json";
}

class GuiTest : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string problem;
    if (!sharedHeadlessContext(problem)) return cannotRunHere(problem);
    takeGlErrors();
    Preferences preferences;
    preferences.uiScale = 1;
    headless = std::make_unique<HeadlessGui>(640, 480, preferences, 2);
  }
  void TearDown() override {
    if (!headless) return;
    headless.reset();
    EXPECT_EQ(takeGlErrors(), "");
  }

  Gui& gui() { return headless->gui(); }
  Editor& editor() { return headless->gui().editor(); }
  UiState& ui() { return headless->gui().ui(); }
  void frames(int count) {
    for (int i = 0; i < count; ++i) headless->frame(1.0 / 60, &draft);
  }

  /// The plane mirror with a box that is soon computed.
  void openSmallLevel() {
    gui().open(levelPath("1-plane"));
    Level level = editor().session.level();
    std::get<BoxShape>(level.original.shape).segments = 4;
    editor().session.edit(level);
  }
  /// Frames as long as `busy` says so; for what other threads make. The limit only ends a hang.
  template <typename Busy>
  void framesWhile(const Busy& busy) {
    for (int i = 0; i < 40000 && busy(); ++i) {
      frames(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_FALSE(busy());
  }

  static constexpr ViewQuality draft{0.1, 1, 1};
  std::unique_ptr<HeadlessGui> headless;
};

}  // namespace anamorph::testing
