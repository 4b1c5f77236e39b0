// Somebody who knows nothing and tries everything: random events in the whole window, and after each of them
// the things that always have to be true. The same seed gives the same events. Each of them has one frame.
//
// ANAMORPH_MONKEY_EVENTS and ANAMORPH_MONKEY_SEED change how many, and which.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <imgui.h>

#include "cli/program.h"
#include "gui_fixture.h"
#include "level/level_json.h"
#include "panels/actions.h"
#include "panels/dialogs.h"
#include "panels/view_panel.h"
#include "random_scene.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;

int numberFromEnvironment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text && *text ? std::atoi(text) : otherwise;
}

// The text of a level names every number that it has.
bool allFinite(const Level& level) {
  static const std::regex odd(R"((:|,|\[)\s*-?(nan|inf))");
  return !std::regex_search(formatLevel(level), odd);
}

bool isSound(const ViewPose& pose) {
  return isFinite(pose.eye) && isFinite(pose.target) && isFinite(pose.up) && std::isfinite(pose.fovDegrees) &&
         pose.fovDegrees > 0 && pose.fovDegrees < 180 && pose.eye != pose.target && pose.up != Vector(0);
}

// The installed levels, with meshes small enough for thousands of frames.
void writeSmallLevels(const fs::path& folder) {
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    Level level = loadLevel(entry.path).level;
    level.sculpture.maxTriangles = 6000;
    level.sculpture.imageSize = 128;
    if (auto* box = std::get_if<BoxShape>(&level.original.shape)) box->segments = 6;
    saveLevel(folder / (entry.name + ".json"), level);
  }
}

class Monkey : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (!headless) return;
    home_ = fs::current_path();
    fs::current_path(folder_ / "");                            // the render dialog may save its picture
    ui().browser.root = fs::path(folder_ / "").parent_path();  // and nothing is written elsewhere
    ui().browser.recentFolders = {ui().browser.root};
    writeSmallLevels(folder_ / "");
    ui().levels = listLevels(folder_ / "");
    ASSERT_GE(ui().levels.size(), 3u);
    gui().open(ui().levels.front().path);
#if IMGUI_VERSION_NUM < 18700
    ImGuiIO& io = ImGui::GetIO();
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = firstKey + key;
#endif
  }
  void TearDown() override {
    if (headless) fs::current_path(home_);
    GuiTest::TearDown();
  }

  template <typename T>
  const T& oneOf(const std::vector<T>& choices) {
    return choices[static_cast<std::size_t>(random_.integer(0, static_cast<int>(choices.size()) - 1))];
  }
  bool chance(double probability) {
    return random_.uniform(0, 1) < probability;
  }

  // Anywhere in the rectangle, more often at its edges than by chance.
  Pixel placeIn(const Rect& r) {
    const auto along = [&](float from, float length) {
      if (chance(0.1)) return static_cast<double>(from);
      return random_.uniform(from, from + std::max(1.0f, length));
    };
    return {along(r.x, r.width), along(r.y, r.height)};
  }

  Pixel place() {
    const Layout& l = ui().layout;
    const Rect all{0, 0, static_cast<float>(headless->width()), static_cast<float>(headless->height())};
    if (chance(0.25)) {
      if (const auto grip = gizmoGrip()) return *grip;
    }
    if (chance(0.03)) return {-1e30, -1e30};  // outside, as Dear ImGui has it
    if (chance(0.03)) return {random_.uniform(-5000, 5000), random_.uniform(-5000, 5000)};
    return placeIn(oneOf<Rect>(
        {l.view, l.view, l.view, l.properties, l.properties, l.preview, l.left, l.menu, l.status, all}));
  }

  std::optional<Pixel> gizmoGrip() {
    const ShownGizmo shown = currentGizmo(editor(), ui());
    if (shown.gizmo.empty()) return std::nullopt;
    const GizmoShape& shape = oneOf(shown.gizmo.shapes);
    if (shape.points.empty()) return std::nullopt;
    return oneOf(shape.points) + Pixel(ui().layout.view.x, ui().layout.view.y);
  }

  void moveTo(const Pixel& at) {
    headless->moveMouse(static_cast<float>(at.x), static_cast<float>(at.y));
  }

  void pressKey() {
    if (chance(0.2)) {
      imguiKey(random_.integer(0, ImGuiKey_COUNT - 1), chance(0.5));
      return;
    }
    if (chance(0.2)) {
      gui().key(random_.integer(0, 348), random_.integer(0, 15));
    } else {
      const ActionRow& row = rowOf(static_cast<Action>(random_.integer(0, int(actionCount) - 1)));
      const Key key = oneOf(keysOf(row, ui().preferences.vrtKeys));
      gui().key(key.code, key.modifiers);
    }
    ui().requests.quit = false;
  }

  void imguiKey([[maybe_unused]] int key, [[maybe_unused]] bool down) {
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeysDown[firstKey + key] = down;
#endif
  }

  void typeSomething() {
    static const std::vector<std::string> texts{
        "0",         "1",     "-1",     "2.5",    "1e6",
        "-1e6",      "1e999", "-1e999", "*1e999", "/0",
        "0.0000001", "1e-30", "*-1",    "+5",     "12345678901234567890",
        "-",         "e",     "",       "nan",    "1e308",
        "64",        "1024",  "0.25"};
    for (const char c : oneOf(texts)) ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
    if (chance(0.05)) ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(random_.integer(1, 0x10FFFF)));
  }

  // A number is double-clicked, typed and left in one way or another.
  void typeIntoSomeNumber() {
    headless->pressMouse(0, false);
    const Rect& r = ui().layout.properties;
    moveTo({r.x + random_.uniform(0.45, 0.95) * r.width, random_.uniform(r.y, r.y + r.height)});
    for (const bool down : {false, true, false, true, false}) {
      headless->pressMouse(0, down);
      check();
    }
    typeSomething();
    check();
    const int key = oneOf<int>({ImGuiKey_Enter, ImGuiKey_Escape, ImGuiKey_Tab});
    imguiKey(key, true);
    check();
    imguiKey(key, false);
  }

  // Small windows most of the time: their frames are quick.
  void resize() {
    static const std::vector<std::pair<int, int>> rare{{1, 1},      {1, 480},     {640, 1},    {320, 200},
                                                       {300, 1500}, {3840, 2160}, {2000, 260}, {1280, 800}};
    static const std::vector<std::pair<int, int>> usual{{640, 480}, {700, 400}, {600, 520}};
    const auto [width, height] = oneOf(chance(0.5) ? rare : usual);
    headless->resize(width, height);
  }
  bool unusual() const {
    return headless->height() < 400 || headless->width() < 600 ||
           headless->height() * headless->width() > 4e5;
  }

  // From a handle of the gizmo, or from anywhere, in some steps; sometimes something happens on the way.
  void drag() {
    for (int button = 0; button < 5; ++button) headless->pressMouse(button, false);
    check();
    const double which = random_.uniform(0, 1);
    const Rect& numbers = ui().layout.properties;
    Pixel at = place();
    if (which < 0.5) at = gizmoGrip().value_or(at);
    if (which > 0.75) at = Pixel(numbers.x + 0.6 * numbers.width, placeIn(numbers).y);
    moveTo(at);
    check();
    const int button = chance(0.8) ? 0 : random_.integer(1, 2);
    headless->pressMouse(button, true);
    check();
    for (int i = random_.integer(1, 6); i > 0; --i) {
      at += Pixel(random_.uniform(-30, 30), random_.uniform(-30, 30));
      moveTo(at);
      if (chance(0.05)) pressKey();
      check();
    }
    if (chance(0.1)) gui().key(keys::escape, 0);
    headless->pressMouse(button, false);
  }

  void undoStorm() {
    const bool back = chance(0.5);
    for (int i = random_.integer(1, 30); i > 0; --i) {
      gui().key(back || chance(0.3) ? 'Z' : 'Y', keys::control);
      if (i % 7 == 0) check();
    }
  }

  void answerDialog() {
    gui().key(oneOf<int>({keys::escape, keys::escape, keys::enter, keys::down, keys::backspace, 'D'}), 0,
              chance(0.1));
    ui().requests.quit = false;
  }

  void event() {
    if (isDialogOpen(ui()) && chance(0.4)) return answerDialog();
    if (unusual() && chance(0.2)) headless->resize(640, 480);
    const double which = random_.uniform(0, 1);
    if (which < 0.25) {
      moveTo(place());
    } else if (which < 0.40) {
      headless->pressMouse(chance(0.75) ? 0 : random_.integer(0, 4), chance(0.5));
    } else if (which < 0.55) {
      drag();
    } else if (which < 0.62) {
      headless->turnWheel(
          static_cast<float>(chance(0.9) ? random_.integer(-3, 3) : random_.uniform(-1e4, 1e4)));
    } else if (which < 0.66) {
      headless->holdModifiers(random_.integer(0, 3));
    } else if (which < 0.79) {
      pressKey();
    } else if (which < 0.83) {
      typeSomething();
    } else if (which < 0.88) {
      typeIntoSomeNumber();
    } else if (which < 0.895) {
      resize();
    } else if (which < 0.90) {
      ui().preferences.uiScale = oneOf<double>({0, 0.75, 1, 1, 1, 2, 3});
      ui().preferences.theme = static_cast<Theme>(random_.integer(0, 2));
    } else if (which < 0.905) {
      ui().requests.open = oneOf(ui().levels).path;
    } else if (which < 0.92) {
      undoStorm();
    } else {
      editor().selection = {static_cast<Part>(random_.integer(0, 6)), random_.integer(0, 2)};
    }
  }

  // A frame, and what is true after every one.
  void check() {
    headless->frame(chance(0.9) ? 1.0 / 60 : random_.uniform(0, 2), &draft);
    ++frames_;
    ui().requests.quit = false;
    if (editor().session.generation() != generation_) {
      generation_ = editor().session.generation();
      begun_ = editor().session.level();
    }
    ui().render.longerSide = std::min(ui().render.longerSide, 96);
    ui().render.samplesPerAxis = 1;
    ASSERT_EQ(takeGlErrors(), "");
    if (!(editor().session.level() == checked_)) {
      checked_ = editor().session.level();
      ++changes_;
      ASSERT_TRUE(allFinite(checked_)) << formatLevel(checked_);
    }
    ASSERT_TRUE(isSound(editor().pose));
  }

  Level checked_;
  Level begun_;  // the level as it was opened
  int generation_ = 0;
  int frames_ = 0, changes_ = 0;
  TemporaryFolder folder_;
  fs::path home_;
  Random random_{static_cast<unsigned>(numberFromEnvironment("ANAMORPH_MONKEY_SEED", 20240611))};
  static constexpr int firstKey = 100;
};

TEST_F(Monkey, BreaksNothing) {
  const int events = numberFromEnvironment("ANAMORPH_MONKEY_EVENTS", 5000);
  std::printf("seed %d, %d events\n", numberFromEnvironment("ANAMORPH_MONKEY_SEED", 20240611), events);
  check();
  for (int i = 0; frames_ < events; ++i) {
    SCOPED_TRACE("frame " + std::to_string(frames_));
    event();
    check();
    if (HasFatalFailure()) return;
    if (i % 25 == 0) {
      const std::string text = formatLevel(editor().session.level());
      ASSERT_NO_THROW(ASSERT_EQ(parseLevel(text, "level").level, editor().session.level()))
          << "it could not be saved and opened again:\n"
          << text;
    }
  }
  for (int button = 0; button < 5; ++button) headless->pressMouse(button, false);
  headless->moveMouse(-1, -1);
  for (int i = 0; i < 3; ++i) check();
  std::printf("%d times another level\n", changes_);
  // Whatever has happened, the history leads back to the level as it was opened.
  Session& session = editor().session;
  while (session.canUndo()) session.undo();
  EXPECT_EQ(session.level(), begun_);
  check();
  while (session.canRedo()) session.redo();
  check();
}

}  // namespace
}  // namespace anamorph::testing
