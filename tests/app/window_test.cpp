// The program in its window, as its users have it.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cannot_run_here.h"
#include "edit/editor.h"
#include "level/level_json.h"
#include "panels/view_panel.h"
#include "window_fixture.h"

namespace anamorph::testing {
namespace {

using ::testing::HasSubstr;

ViewPose poseOf(const State& state) {
  const JsonValue& json = state["pose"];
  const auto member = [&](const std::string& key) -> const JsonValue& {
    const auto at = std::find(json.keys.begin(), json.keys.end(), key);
    return json.items.at(static_cast<std::size_t>(at - json.keys.begin()));
  };
  return {State::vectorOf(member("eye")), State::vectorOf(member("target")), State::vectorOf(member("up")),
          member("fovDegrees").number, member("orthographic").text == "true"};
}

Rect rectOf(const std::vector<double>& list) {
  return {static_cast<float>(list.at(0)), static_cast<float>(list.at(1)), static_cast<float>(list.at(2)),
          static_cast<float>(list.at(3))};
}

// The same level in this process, seen from where the window sees it: it knows what is where.
class Twin {
 public:
  explicit Twin(const std::string& level) : editor_({}, 2) {
    openLevel(editor_, level);
    editor_.updater.finish(editor_.session, {});
  }
  void follow(const State& state) {
    ui_.layout.view = rectOf(state.list("view"));
    ui_.scale = state.number("scale");
    editor_.pose = poseOf(state);
    editor_.viewWidth = static_cast<int>(ui_.layout.view.width);
    editor_.viewHeight = static_cast<int>(ui_.layout.view.height);
  }
  // A place in the window where a click meets what is wanted.
  std::optional<Pixel> placeOf(const std::function<bool(const Pick&)>& wanted) {
    for (double y = 10; y < editor_.viewHeight - 10; y += 9) {
      for (double x = 10; x < editor_.viewWidth - 10; x += 9) {
        const Pixel p(x, y);
        // Not at an edge: a pixel to either side it has to be the same.
        const bool all = wanted(pickAt(editor_, ui_, p)) && wanted(pickAt(editor_, ui_, p + Pixel(4, 0))) &&
                         wanted(pickAt(editor_, ui_, p + Pixel(0, 4)));
        if (all) return inWindow(p);
      }
    }
    return std::nullopt;
  }
  std::optional<Pixel> gripOf(const Selection& selection, GizmoHandle handle) {
    editor_.selection = selection;
    const Gizmo gizmo = currentGizmo(editor_, ui_).gizmo;
    editor_.selection = {};
    for (const GizmoShape& shape : gizmo.shapes) {
      if (shape.handle != handle || shape.points.empty()) continue;
      Pixel middle(0);
      for (const Pixel& p : shape.points) middle += p / double(shape.points.size());
      if (pickHandle(gizmo, middle) == handle) return inWindow(middle);
    }
    return std::nullopt;
  }

 private:
  Pixel inWindow(const Pixel& p) const { return p + Pixel(ui_.layout.view.x, ui_.layout.view.y); }

  Editor editor_;
  UiState ui_;
};

std::string levelFile(const std::string& name) {
  return std::string(ANAMORPH_LEVELS) + "/" + name + ".json";
}

class RealWindow : public WindowTest {
 protected:
  void start(const std::string& level = "2-cylinder", std::vector<std::string> more = {}) {
    more.insert(more.begin(), {levelFile(level), "--size", "1000x700", "--ui-scale", "1"});
    window = std::make_unique<VirtualWindow>(more);
    ASSERT_TRUE(window->settle()) << window->errorText();
    window->move(5, 690);  // the pointer is in the window, over nothing: it gets the keys
    twin = std::make_unique<Twin>(levelFile(level));
    twin->follow(window->state());
  }
  State state() const { return window->state(); }

  // Selects the original and begins to drag its x arrow; the button stays down.
  void dragOriginal() {
    const auto place = twin->placeOf([](const Pick& p) { return p.selection.part == Part::original; });
    ASSERT_TRUE(place) << "the original is not to be seen";
    window->click(place->x, place->y);
    ASSERT_TRUE(window->waitFor([](const State& s) { return s.text("selection") == "original"; }));
    window->key("w");  // the arrows in the place of the construction
    ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("pointPicked"); }));
    const auto grip = twin->gripOf({Part::original}, GizmoHandle::x);
    ASSERT_TRUE(grip);
    window->dragTo(grip->x, grip->y, grip->x + 30, grip->y);
  }

  std::unique_ptr<Twin> twin;
};

TEST_F(RealWindow, OpensAndSettles) {
  start();
  EXPECT_EQ(state().list("window"), (std::vector<double>{1000, 700}));
  EXPECT_TRUE(state().is("refined"));
  EXPECT_GT(state().number("iou"), 0.99);
  EXPECT_FALSE(state().is("modified"));
  EXPECT_EQ(state().text("problem"), "");
  EXPECT_EQ(window->errorText(), "");
}

// What that costs is measured by a benchmark (benchmarks/idle_bench.cpp).
TEST_F(RealWindow, DrawsNothingWhileNothingHappens) {
  start();
  ASSERT_TRUE(window->rest());
  const double frames = state().number("frame");
  sleepFor(3);  // to look, not to wait: a busy machine draws less, not more
  EXPECT_EQ(state().number("frame"), frames) << "drawn though nothing has changed";
}

TEST_F(RealWindow, OrbitPanAndZoomChangeTheViewOnly) {
  start();
  const auto sky = twin->placeOf([](const Pick& p) { return p.selection.part == Part::none && !p.cell; });
  ASSERT_TRUE(sky);
  const State before = state();
  window->dragTo(sky->x, sky->y, sky->x + 60, sky->y + 20);
  window->release();
  ASSERT_TRUE(window->waitFor([&](const State& s) { return poseOf(s).eye != poseOf(before).eye; }));
  EXPECT_EQ(poseOf(state()).target, poseOf(before).target) << "turned, not shifted";
  window->dragTo(sky->x, sky->y, sky->x + 50, sky->y, 3);
  window->release(3);
  ASSERT_TRUE(window->waitFor([&](const State& s) { return poseOf(s).target != poseOf(before).target; }));
  const auto distance = [](const ViewPose& pose) { return glm::length(pose.eye - pose.target); };
  const double far = distance(poseOf(state()));
  window->turnWheelUp();
  EXPECT_TRUE(window->waitFor([&](const State& s) { return distance(poseOf(s)) < far; }));
  ASSERT_TRUE(window->settle());
  EXPECT_FALSE(state().is("canUndo"));
  EXPECT_FALSE(state().is("modified"));
  EXPECT_EQ(state().vector("eye"), before.vector("eye"));
  EXPECT_EQ(state().number("iou"), before.number("iou"));
}

TEST_F(RealWindow, DragOfTheGizmoIsFollowedAndUndone) {
  start();
  const State before = state();
  dragOriginal();
  ASSERT_TRUE(window->waitFor([&](const State& s) {
    return s.is("changing") && s.vector("original") != before.vector("original") &&
           s["iou"].kind == JsonValue::Kind::number;
  })) << "level and score follow while the button is down";
  window->release();
  ASSERT_TRUE(window->settle());
  const State after = state();
  EXPECT_TRUE(after.is("canUndo"));
  EXPECT_TRUE(after.is("modified"));
  EXPECT_GT(std::abs(after.vector("original").x - before.vector("original").x), 0.1);
  EXPECT_EQ(after.vector("original").y, before.vector("original").y);
  EXPECT_GT(after.number("iou"), 0.9);
  window->key("ctrl+z");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("canUndo"); })) << "it was one step";
  EXPECT_EQ(state().vector("original"), before.vector("original"));
  EXPECT_FALSE(state().is("modified"));
  window->key("ctrl+y");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("canUndo"); }));
  EXPECT_EQ(state().vector("original"), after.vector("original"));
  ASSERT_TRUE(window->settle());
  EXPECT_EQ(state().number("iou"), after.number("iou")) << "the same level has the same score";
}

TEST_F(RealWindow, EscTakesADragBack) {
  start();
  const State before = state();
  dragOriginal();
  ASSERT_TRUE(
      window->waitFor([&](const State& s) { return s.vector("original") != before.vector("original"); }));
  window->key("Escape");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("changing"); }));
  EXPECT_EQ(state().vector("original"), before.vector("original"));
  window->moveBy(20, 0);
  window->release();
  ASSERT_TRUE(window->settle());
  EXPECT_EQ(state().vector("original"), before.vector("original"));
  EXPECT_FALSE(state().is("canUndo"));
}

TEST_F(RealWindow, LettersAreThoseOnTheKeys) {
  if (!isInstalled("setxkbmap")) return cannotRunHere("setxkbmap is not installed");
  start();
  // On German keyboards Y and Z have changed places.
  window->shell("setxkbmap de");
  dragOriginal();
  window->release();
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("canUndo") && !s.is("changing"); }));
  window->key("ctrl+z");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("canRedo"); }));
  window->key("ctrl+y");
  EXPECT_TRUE(window->waitFor([](const State& s) { return s.is("canUndo"); }));
}

TEST_F(RealWindow, ShortTapsOfKeysAreSeenInTextFields) {
  start();
  const State before = window->state();
  const std::vector<double> r = before.list("properties");
  const double x0 = before.vector("eye").x;
  // The first number of Eye.
  window->move(r[0] + 0.46 * r[2], r[1] + 111);
  window->hold("ctrl");
  window->press();
  window->release();
  window->letGoOf("ctrl");
  window->type("3.5");
  window->key("Return");  // down and up within a frame
  EXPECT_TRUE(window->waitFor([&](const State& s) { return s.vector("eye").x == 3.5 && !s.is("changing"); }))
      << x0;
}

TEST_F(RealWindow, AClickInThePreviewPicksAPixel) {
  start();
  const Rect preview = rectOf(state().list("preview"));
  ASSERT_FALSE(preview.empty());
  const double x = preview.x + 0.5 * preview.width + 3, y = preview.y + 0.4 * preview.height;
  window->click(x, y);
  ASSERT_TRUE(window->waitFor([](const State& s) { return s["cell"].kind == JsonValue::Kind::array; }));
  const auto cell = state().list("cell");
  EXPECT_EQ(cell[0], 4) << "just right of the middle of 8 columns";
  EXPECT_FALSE(state().is("canUndo")) << "it is looking, not editing";
  window->key("Escape");
  EXPECT_TRUE(window->waitFor([](const State& s) { return s["cell"].kind == JsonValue::Kind::null; }));
  window->click(x, y);
  ASSERT_TRUE(window->waitFor([](const State& s) { return s["cell"].kind == JsonValue::Kind::array; }));
  window->click(x, y);
  EXPECT_TRUE(window->waitFor([](const State& s) { return s["cell"].kind == JsonValue::Kind::null; }))
      << "a second click shows all again";
}

TEST_F(RealWindow, PageUpAndDownChangeTheLevel) {
  start("1-plane");
  const auto isLevel = [](const char* name) {
    return [name](const State& s) {
      return std::filesystem::path(s.text("level")).stem() == name && s.settled();
    };
  };
  window->key("Next");
  ASSERT_TRUE(window->waitFor(isLevel("2-cylinder")));
  window->key("Next");
  ASSERT_TRUE(window->waitFor(isLevel("3-sphere")));
  EXPECT_GT(state().number("iou"), 0.99);
  window->key("Prior");
  ASSERT_TRUE(window->waitFor(isLevel("2-cylinder")));
  EXPECT_FALSE(state().is("modified"));
}

TEST_F(RealWindow, KeysForTheView) {
  start();
  const ViewPose before = poseOf(state());
  window->key("0");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("lookingThrough") && s.settled(); }));
  EXPECT_LT(glm::length(poseOf(state()).eye - state().vector("eye")), 1e-9);
  window->key("0");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("lookingThrough") && s.settled(); }));
  EXPECT_EQ(poseOf(state()), before) << "back to where it began";
  window->key("F2");
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.is("panelsHidden"); }));
  EXPECT_EQ(state().list("view"), (std::vector<double>{0, 0, 1000, 700}));
  window->key("F2");
  ASSERT_TRUE(window->waitFor([](const State& s) { return !s.is("panelsHidden"); }));
  window->key("F1");
  EXPECT_TRUE(window->waitFor([](const State& s) { return s.is("helpOpen"); }));
  window->key("Escape");
  EXPECT_TRUE(window->waitFor([](const State& s) { return !s.is("helpOpen"); }));
}

TEST_F(RealWindow, FillsTheScreenAndComesBack) {
  start();
  window->key("F11");
  EXPECT_TRUE(window->waitFor([](const State& s) {
    return s.list("window") == std::vector<double>{2600, 1500};
  }));
  window->key("F11");
  EXPECT_TRUE(window->waitFor([](const State& s) {
    return s.list("window") == std::vector<double>{1000, 700};
  }));
}

TEST_F(RealWindow, CanBeOfAnySize) {
  start();
  for (const auto& [width, height] :
       {std::pair{320, 200}, {1, 1}, {321, 1400}, {2500, 220}, {640, 480}, {2560, 1440}, {1000, 700}}) {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    window->resize(width, height);
  }
  EXPECT_TRUE(window->settle());
  EXPECT_EQ(window->errorText(), "");
}

TEST_F(RealWindow, ClosesWithoutWritingWhatWasNotChanged) {
  start("1-plane");
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(window->program().exitCode(), 0);
  EXPECT_FALSE(std::filesystem::exists(window->preferencesPath()));
  EXPECT_EQ(window->errorText(), "");
}

TEST_F(RealWindow, CanBeClosedWhileItComputes) {
  std::vector<std::string> arguments{levelFile("3-sphere"), "--size", "1000x700"};
  window = std::make_unique<VirtualWindow>(arguments);
  ASSERT_TRUE(window->waitFor([](const State& s) { return s.number("frame") >= 1; }));
  window->askToClose();
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(window->program().exitCode(), 0);
}

TEST_F(RealWindow, KeepsPreferencesThatWereChanged) {
  start("1-plane");
  const Rect properties = rectOf(state().list("properties"));
  window->dragTo(properties.x, properties.y + 100, properties.x - 60, properties.y + 100);
  window->release();
  ASSERT_TRUE(window->waitFor(
      [&](const State& s) { return rectOf(s.list("properties")).width > properties.width + 30; }));
  EXPECT_FALSE(state().is("modified"));
  window->key("ctrl+q");
  ASSERT_TRUE(window->program().waitForEnd());
  EXPECT_EQ(window->program().exitCode(), 0);
  const std::string text = readAll(window->preferencesPath());
  EXPECT_THAT(text, HasSubstr("rightWidth"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("\"rightWidth\": 336")));
}

Result openWith(const Environment& environment, const std::string& display) {
  const TemporaryFolder folder;
  Environment all{{"HOME", folder / ""}, {"XDG_CONFIG_HOME", folder / "config"}, {"DISPLAY", display}};
  for (const auto& [name, value] : environment) all[name] = value;
  Process program({ANAMORPH_PROGRAM, levelFile("1-plane")}, all, folder / "out", folder / "err");
  program.waitForEnd();
  return {program.exitCode(), readAll(folder / "out"), readAll(folder / "err")};
}

TEST_F(RealWindow, WithoutADisplayTheProgramSaysSo) {
  for (const std::string display : {"", ":987"}) {
    const Result result = openWith({{"WAYLAND_DISPLAY", ""}}, display);
    EXPECT_EQ(result.exitCode, 1);
    EXPECT_EQ(result.out, "");
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_THAT(result.err, HasSubstr("display"));
    EXPECT_THAT(result.err, HasSubstr("anamorph screenshot")) << "what else can be done";
  }
}

TEST_F(RealWindow, AnOldOpenGLIsNamed) {
  const VirtualScreen screen;
  const Result result = openWith({{"MESA_GL_VERSION_OVERRIDE", "2.1"}}, screen.display());
  EXPECT_EQ(result.exitCode, 1);
  EXPECT_THAT(result.err, HasSubstr("OpenGL 3.3"));
  EXPECT_THAT(result.err, HasSubstr("OpenGL 2.1")) << "what was found";
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  const Result without = openWith({{"LIBGL_DRIVERS_PATH", "/nonexistent"}}, screen.display());
  EXPECT_EQ(without.exitCode, 1);
  EXPECT_THAT(without.err, HasSubstr("OpenGL 3.3"));
}

TEST_F(RealWindow, ABrokenLevelIsTold) {
  const VirtualScreen screen;
  const TemporaryFolder folder;
  writeText(folder / "broken.json", "{");
  Process program({ANAMORPH_PROGRAM, folder / "broken.json"},
                  {{"DISPLAY", screen.display()}, {"HOME", folder / ""}, {"XDG_CONFIG_HOME", ""}},
                  folder / "out", folder / "err");
  ASSERT_TRUE(program.waitForEnd());
  EXPECT_EQ(program.exitCode(), 1);
  EXPECT_THAT(readAll(folder / "err"), HasSubstr("broken.json"));
}

}  // namespace
}  // namespace anamorph::testing
