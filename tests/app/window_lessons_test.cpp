// Lessons, presenting and exports in the real window, by real keys.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "window_fixture.h"

namespace anamorph::testing {
namespace {

class RealWindowLessons : public WindowTest {
 protected:
  void start(std::vector<std::string> arguments) {
    window.reset();
    arguments.insert(arguments.end(), {"--size", "1000x700", "--ui-scale", "1"});
    window = std::make_unique<VirtualWindow>(arguments, Environment{{"HOME", folder / ""},
                                                                    {"XDG_STATE_HOME", folder / "state"},
                                                                    {"XDG_CONFIG_HOME", folder / "config"}});
    ASSERT_TRUE(wait([](const State& s) { return s.is("complete"); })) << window->errorText();
    window->move(500, 690);
  }
  bool wait(const std::function<bool(const State&)>& wanted) { return window->waitFor(wanted); }

  TemporaryFolder folder;
};

TEST_F(RealWindowLessons, AStepIsShownDoneAndStillDoneAfterARestart) {
  start({"1-plane"});
  EXPECT_EQ(window->state().number("step"), 0);
  window->key("m");  // the first step looks through the RT camera
  ASSERT_TRUE(wait([](const State& s) { return s.is("stepDone"); }));
  window->key("alt+Right");
  ASSERT_TRUE(wait([](const State& s) { return s.number("step") == 1; }));
  EXPECT_TRUE(std::filesystem::exists(folder / "state/anamorph/progress.json"));
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  start({"1-plane"});
  EXPECT_EQ(window->state().number("step"), 1) << "goes on where it was left";
}

TEST_F(RealWindowLessons, PresentsTheStepThatIsNamedAndStepsByArrows) {
  start({"2-cylinder", "--step", "3", "--present", "--theme", "projector"});
  EXPECT_TRUE(window->state().is("presenting"));
  EXPECT_EQ(window->state().number("step"), 2);
  window->key("Right");
  ASSERT_TRUE(wait([](const State& s) { return s.number("step") == 3; }));
  window->key("Left");
  ASSERT_TRUE(wait([](const State& s) { return s.number("step") == 2; }));
  window->key("F3");
  ASSERT_TRUE(wait([](const State& s) { return !s.is("presenting") && !s.is("panelsHidden"); }));
}

TEST_F(RealWindowLessons, ANumberIsChangedByKeysAlone) {
  start({"1-plane"});
  for (int i = 0; i < 3; ++i) window->key("F6");  // levels, lesson, properties
  for (int i = 0; i < 3; ++i) window->key("Down");
  window->key("Return");
  window->type("2.5");
  window->key("Return");
  EXPECT_TRUE(wait([](const State& s) { return s.vector("eye").x == 2.5; }));
  window->key("Escape");
  window->key("ctrl+z");
  EXPECT_TRUE(wait([](const State& s) { return s.vector("eye").x == 0; }));
}

TEST_F(RealWindowLessons, TheFirstStartShowsAroundOnce) {
  start({"0-perspective", "--with-tour"});
  EXPECT_TRUE(window->waitForEver([](const State& s) { return s.number("tourCard") >= 0; }));
  window->key("Escape");
  ASSERT_TRUE(wait([](const State& s) { return s.number("tourCard") == -1; }));
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  start({"0-perspective", "--with-tour"});
  EXPECT_EQ(window->state().number("tourCard"), -1);
}

TEST_F(RealWindowLessons, ExportsByKeysAlone) {
  start({"1-plane"});
  window->key("ctrl+e");
  ASSERT_TRUE(wait([](const State& s) { return s.is("exporting"); }));
  window->key("Return");
  ASSERT_TRUE(wait([](const State& s) { return s.text("dialog") == "browser"; }));
  window->type("take-home.stl");
  ASSERT_TRUE(wait([](const State& s) { return s.text("typed") == "take-home.stl"; }))
      << window->state().text("typed");
  window->key("Return");
  ASSERT_TRUE(wait([](const State& s) { return s.number("exported") == 1; }));
  EXPECT_TRUE(std::filesystem::exists(folder / "take-home.stl"));
  window->key("Escape");
  ASSERT_TRUE(wait([](const State& s) { return !s.is("exporting"); }));
}

}  // namespace
}  // namespace anamorph::testing
