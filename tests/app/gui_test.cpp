#include "app/gui.h"

#include <string>

#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "app/state_log.h"
#include "base/language.h"
#include "cli/program.h"
#include "gui_fixture.h"
#include "level/json.h"
#include "level/level_json.h"
#include "panels/actions.h"
#include "panels/help_buttons.h"
#include "panels/view_panel.h"
#include "save_session.h"

namespace anamorph::testing {
namespace {

class OpenGui : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (!headless) return;
    headless->resize(900, 560);
    gui().open(levelPath("1-plane"));
    frames(3);
  }

  std::optional<Pixel> gripOf(GizmoHandle handle) {
    const Gizmo gizmo = currentGizmo(editor(), ui()).gizmo;
    for (const GizmoShape& shape : gizmo.shapes) {
      if (shape.handle != handle || shape.points.empty()) continue;
      Pixel middle(0);
      for (const Pixel& p : shape.points) middle += p / double(shape.points.size());
      if (pickHandle(gizmo, middle) == handle) return middle + Pixel(ui().layout.view.x, ui().layout.view.y);
    }
    return std::nullopt;
  }
  void moveTo(const Pixel& p) { headless->moveMouse(static_cast<float>(p.x), static_cast<float>(p.y)); }

  // The original is being dragged by its gizmo, the button is down.
  void beginDrag() {
    headless->resize(1280, 800);
    frames(3);
    while (!editor().updater.result().complete) frames(1);
    editor().selection = {Part::original};
    frames(3);
    const auto grip = gripOf(GizmoHandle::x);
    ASSERT_TRUE(grip);
    grip_ = *grip;
    moveTo(grip_);
    frames(2);
    headless->pressMouse(0, true);
    frames(1);
    moveTo(grip_ + Pixel(20, 0));
    frames(2);
    ASSERT_EQ(ui().mouse.drag, ViewDrag::gizmo);
    ASSERT_TRUE(editor().session.changing());
  }

  Pixel grip_{0};
};

TEST_F(OpenGui, ADragInTheViewIsFollowedInTheSameFrame) {
  beginDrag();
  for (int i = 1; i <= 10; ++i) {
    const Level before = editor().session.level();
    moveTo(grip_ + Pixel(20 + 4 * i, 0));
    frames(1);
    EXPECT_FALSE(editor().session.level() == before);
    EXPECT_EQ(editor().updater.result().level, editor().session.level());
  }
}

TEST_F(OpenGui, ADraggedNumberIsFollowedInTheNextFrame) {
  headless->resize(1280, 800);
  frames(3);
  while (!editor().updater.result().complete) frames(1);
  editor().selection = {Part::eye};
  frames(3);
  const Rect& rect = ui().layout.properties;
  const Level before = editor().session.level();
  bool dragged = false;
  for (float y = rect.y + 70; y < rect.y + rect.height && !dragged; y += 5) {
    const Pixel at(rect.x + 0.46f * rect.width, y);
    moveTo(at);
    frames(2);
    headless->pressMouse(0, true);
    frames(1);
    moveTo(at + Pixel(20, 0));
    frames(1);
    dragged = editor().session.changing() && !(editor().session.level() == before);
    if (dragged) break;
    headless->pressMouse(0, false);
    frames(2);
  }
  ASSERT_TRUE(dragged);
  EXPECT_TRUE(gui().unfinished()) << "it is not shown yet";
  frames(1);
  EXPECT_EQ(editor().updater.result().level, editor().session.level());
  EXPECT_FALSE(editor().updater.result().level == before);
  headless->pressMouse(0, false);
  frames(2);
}

TEST_F(OpenGui, AnotherLevelEndsTheDrag) {
  beginDrag();
  gui().key(keys::pageDown, 0);
  frames(1);
  moveTo(grip_ + Pixel(40, 0));
  frames(3);
  const Level& level = editor().session.level();
  EXPECT_EQ(editor().session.path().filename(), "2-cylinder.json");
  EXPECT_EQ(level, loadLevel(levelPath("2-cylinder")).level) << "the drag is over";
  headless->pressMouse(0, false);
  frames(2);
  EXPECT_FALSE(editor().session.canUndo());
}

TEST_F(OpenGui, ReloadingEndsTheDrag) {
  beginDrag();
  gui().key(keys::f5, 0);
  frames(1);
  moveTo(grip_ + Pixel(40, 0));
  frames(3);
  EXPECT_EQ(editor().session.level(), loadLevel(levelPath("1-plane")).level);
  EXPECT_FALSE(editor().session.modified());
}

TEST_F(OpenGui, ALevelThatCannotBeOpenedLeavesTheOldOne) {
  const TemporaryFolder folder;
  const auto ask = [&](const std::filesystem::path& file) {
    ui().requests.open = file;
    do frames(1);
    while (editor().opening.busy());
    frames(2);
  };
  writeText(folder / "broken.json", "{");
  ask(folder / "broken.json");
  EXPECT_EQ(editor().session.level(), loadLevel(levelPath("1-plane")).level);
  ASSERT_TRUE(ui().notice);
  EXPECT_NE(ui().notice->text.find("broken.json"), std::string::npos);
  ask(folder / "gone.json");
  EXPECT_NE(ui().notice->text.find("gone.json"), std::string::npos);
  gui().key(keys::enter, 0);
  frames(2);
  EXPECT_FALSE(ui().notice);
}

TEST_F(OpenGui, AMeshThatIsDroppedIsTheOriginal) {
  while (!editor().updater.result().complete) frames(1);
  gui().drop({std::filesystem::path(ANAMORPH_TEST_DATA) / "meshes/cube.obj"});
  EXPECT_TRUE(gui().unfinished());
  for (int i = 0; i < 2000 && editor().job.busy(); ++i) frames(1);
  ASSERT_TRUE(std::holds_alternative<FileShape>(editor().session.level().original.shape));
  while (!editor().updater.result().complete) frames(1);
  EXPECT_EQ(editor().updater.result().problem, std::nullopt);
  EXPECT_GT(editor().updater.result().match->report.silhouetteIou, 0.95);
  gui().key('Z', keys::control);
  EXPECT_FALSE(editor().session.modified());
}

TEST_F(OpenGui, ALevelThatIsDroppedWaitsForTheQuestion) {
  const TemporaryFolder folder;
  const std::string own = folder / "own.json";  // an installed one is left without a question
  Level level = editor().session.level();
  testing::saveTo(editor().session, own);
  level.sculpture.depthScale = 2;
  editor().session.edit(level);
  gui().drop({levelPath("3-sphere")});
  frames(2);
  EXPECT_EQ(editor().session.path(), own);
  ASSERT_TRUE(ui().unsaved);
  gui().key('D', 0);
  frames(2);
  EXPECT_EQ(editor().session.path(), levelPath("3-sphere"));
}

TEST_F(OpenGui, TheEyeIsLiftedWithoutStopping) {
  while (!editor().updater.result().complete) frames(1);
  Level level = editor().session.level();
  level.camera.eye.z = 1;
  editor().session.edit(level);
  frames(1);
  while (!editor().updater.result().complete) frames(1);
  ASSERT_GT(editor().updater.result().match->report.hiddenShare, 0);
  startLift(editor());
  int drawn = 0;
  for (; drawn < 5000 && editor().job.busy(); ++drawn) frames(1);
  EXPECT_GT(drawn, 3) << "frames go on meanwhile";
  EXPECT_GT(editor().session.level().camera.eye.z, 1) << editor().status.text();
  frames(1);
  while (!editor().updater.result().complete) frames(1);
  EXPECT_EQ(editor().updater.result().match->report.hiddenShare, 0);
}

TEST_F(GuiTest, WithoutAnyLevelTheErrorIsTheCallers) {
  EXPECT_THROW(gui().open("/nowhere/at/all.json"), Error);
}

TEST_F(OpenGui, RestsWhenAllIsDone) {
  headless->settle();
  EXPECT_FALSE(gui().unfinished());
  for (int i = 0; i < 5; ++i) {
    const ViewQuality best = QualityGovernor::best();
    headless->frame(1.0 / 60, &best);
    EXPECT_FALSE(gui().unfinished());
  }
  EXPECT_TRUE(editor().updater.result().complete);
}

TEST_F(OpenGui, TheMouseInTheViewChangesNoPictureByBeingThere) {
  headless->settle();
  headless->moveMouse(400, 300);
  const ViewQuality best = QualityGovernor::best();
  for (int i = 0; i < 4; ++i) headless->frame(1.0 / 60, &best);
  EXPECT_FALSE(gui().unfinished()) << "hovering is no reason to draw the 3D view again";
}

TEST_F(OpenGui, SaysWhatTheViewCannotShow) {
  const auto isSaid = [] {
    const ImGuiWindow* window = ImGui::FindWindowByName("##view-problem");
    return window && window->Active;
  };
  const auto light = [&](std::size_t count) {
    Level level = editor().session.level();
    level.lights.resize(count);
    editor().session.edit(std::move(level));
    frames(3);
  };
  light(16);
  EXPECT_EQ(ui().viewProblem, "");
  EXPECT_FALSE(isSaid());
  light(17);
  EXPECT_NE(ui().viewProblem.find("first 16 lights"), std::string::npos) << ui().viewProblem;
  EXPECT_TRUE(isSaid());
  ui().preferences.language = "nl";
  frames(3);
  EXPECT_NE(ui().viewProblem.find("eerste 16 lampen"), std::string::npos) << ui().viewProblem;
  setLanguage(nullptr);
  ui().bare = true;
  frames(3);
  EXPECT_FALSE(isSaid()) << "a picture of the things alone";
  ui().bare = false;
  light(16);
  EXPECT_EQ(ui().viewProblem, "");
  EXPECT_FALSE(isSaid());
}

TEST_F(OpenGui, StateLineIsJson) {
  while (!editor().updater.result().complete) frames(1);
  editor().cell = GridCell{3, 5};
  frames(1);
  const JsonValue state = parseJson(stateLine(gui(), 7, {.keysDown = 4, .motions = 9}, true), "state");
  const auto member = [&](const std::string& key) -> const JsonValue& {
    const auto at = std::find(state.keys.begin(), state.keys.end(), key);
    if (at == state.keys.end()) throw Error("no member " + key);
    return state.items[static_cast<std::size_t>(at - state.keys.begin())];
  };
  EXPECT_EQ(member("frame").number, 7);
  EXPECT_EQ(member("window").items[0].number, 900);
  EXPECT_EQ(member("cell").items[1].number, 5);
  EXPECT_EQ(member("selection").text, "none");
  EXPECT_GT(member("iou").number, 0.99);
  EXPECT_EQ(member("complete").text, "true");
  EXPECT_EQ(member("resting").text, "true");
  EXPECT_EQ(findMember(member("input"), "keysDown")->number, 4);
  EXPECT_EQ(findMember(member("input"), "motions")->number, 9);
}

}  // namespace
}  // namespace anamorph::testing
