#include "panels/panels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "base/language.h"
#include "edit/advance.h"
#include "optics/extrusion.h"
#include "panels/widgets.h"
#include "panels_fixture.h"

namespace anamorph::testing {
namespace {

const std::vector<std::string> levelNames{"1-plane", "2-cylinder", "3-sphere"};
constexpr PropertyTab allTabs[] = {PropertyTab::eye,       PropertyTab::original, PropertyTab::mirror,
                                   PropertyTab::sculpture, PropertyTab::lights,   PropertyTab::rays,
                                   PropertyTab::view};

std::vector<Selection> selectionsOf(const Level& level) {
  std::vector<Selection> all{{Part::none},   {Part::eye},       {Part::aim},  {Part::original},
                             {Part::mirror}, {Part::sculpture}, {Part::light}};
  for (int i = 1; i < static_cast<int>(level.lights.size()); ++i) all.push_back({Part::light, i});
  return all;
}

void moveEyeOntoMirror(Editor& editor) {
  Level level = editor.session.level();
  level.camera.eye = pointAt(level.optic.shape(), 0.2, 0.6);
  editor.session.edit(level);
}

struct State {
  const char* name;
  void (*enter)(Editor&, UiState&);
};

constexpr State states[] = {
    {"as opened", [](Editor&, UiState&) {}},
    {"panels hidden", [](Editor&, UiState& ui) { ui.panelsHidden = true; }},
    {"help", [](Editor&, UiState& ui) { ui.helpOpen = true; }},
    {"render dialog", [](Editor&, UiState& ui) { ui.render.open = true; }},
    {"render dialog, running",
     [](Editor&, UiState& ui) {
       ui.render.open = ui.render.running = true;
       ui.render.fraction = 0.3;
     }},
    {"preview expanded", [](Editor& editor, UiState&) { editor.preview.expanded = true; }},
    {"wipe", [](Editor& editor, UiState&) { editor.preview.tab = PreviewTab::wipe; }},
    {"picked point",
     [](Editor& editor, UiState&) {
       editor.point = pickedVertex(*editor.updater.result().original.mesh, 17);
     }},
    {"picked cell",
     [](Editor& editor, UiState&) {
       editor.cell = GridCell{3, 4};
       editor.rays.source = RaySource::pixels;
       editor.rays.lightRays = true;
       editor.rays.hideNoHit = false;
     }},
    {"looking through",
     [](Editor& editor, UiState&) {
       toggleLookThrough(editor);
       advance(editor, 1);
     }},
    {"eye on the mirror", [](Editor& editor, UiState&) { moveEyeOntoMirror(editor); }},
    {"original shown by a file that is gone",
     [](Editor& editor, UiState&) {
       Level level = editor.session.level();
       level.original.shape = FileShape{"nowhere.obj"};
       editor.session.edit(level);
     }},
    {"rotating", [](Editor& editor, UiState&) { editor.gizmoMode = GizmoMode::rotate; }},
    {"scaling", [](Editor& editor, UiState&) { editor.gizmoMode = GizmoMode::scale; }},
    {"long message", [](Editor& editor, UiState&) { editor.status.say(std::string(3000, 'w')); }},
};

class EveryLevel : public PanelsTest, public ::testing::WithParamInterface<std::string> {};

TEST_P(EveryLevel, EveryTabOfEverySelectionInEveryStateIsDrawn) {
  for (const State& state : states) {
    SCOPED_TRACE(state.name);
    ui = UiState{};
    ui.levels = listLevels(ANAMORPH_LEVELS);
    editor.display = {};
    editor.rays = {};
    editor.preview = {};
    editor.gizmoMode = GizmoMode::move;
    open(GetParam());
    state.enter(editor, ui);
    for (const Selection& selection : selectionsOf(editor.session.level())) {
      editor.selection = selection;
      frame();
      for (const PropertyTab tab : allTabs) {
        SCOPED_TRACE("part " + std::to_string(int(selection.part)) + ", tab " + std::to_string(int(tab)));
        ui.tabs.open = tab;
        ASSERT_NO_THROW(frames(2));
        EXPECT_EQ(ui.tabs.open, tab);
        EXPECT_EQ(editor.selection, selection);
      }
    }
    EXPECT_FALSE(editor.session.changing());
  }
}

TEST_P(EveryLevel, DrawingChangesNothing) {
  open(GetParam());
  const Level before = editor.session.level();
  for (const PropertyTab tab : allTabs) {
    ui.tabs.open = tab;
    frames(4);
  }
  EXPECT_EQ(editor.session.level(), before);
  EXPECT_FALSE(editor.session.canUndo());
}

TEST_P(EveryLevel, FitsIntoEveryWindow) {
  open(GetParam());
  for (const ImVec2 size :
       {ImVec2{1, 1}, {2, 700}, {700, 2}, {320, 200}, {640, 480}, {1280, 800}, {3840, 2160}, {800, 3000}}) {
    for (const Theme theme : {Theme::dark, Theme::light, Theme::projector}) {
      for (const double scale : {0.75, 1.0, 3.0}) {
        for (const bool expanded : {false, true}) {
          SCOPED_TRACE(std::to_string(size.x) + " x " + std::to_string(size.y) + " at " +
                       std::to_string(scale));
          ImGui::GetIO().DisplaySize = size;
          setLook(theme, scale);
          editor.preview.expanded = expanded;
          for (const PropertyTab tab : allTabs) {
            ui.tabs.open = tab;
            ASSERT_NO_THROW(frame());
          }
          EXPECT_GE(editor.viewWidth, 1);
          EXPECT_GE(editor.viewHeight, 1);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Panels, EveryLevel, ::testing::ValuesIn(levelNames),
                         [](const auto& level) { return level.param.substr(2); });

bool eyeMovedInX(const Level& before, const Level& now) {
  return before.camera.eye.x != now.camera.eye.x;
}

class NumberRow : public PanelsTest {
 protected:
  void SetUp() override {
    open("3-sphere");
    editor.selection = {Part::eye};
    frames(3);
    opened = editor.session.level();
  }

  Level opened;
};

TEST_F(NumberRow, DraggedByTheMouseIsOneStep) {
  const auto at = dragRow(eyeMovedInX);
  ASSERT_TRUE(at) << "no number to drag";
  for (int i = 0; i < 10; ++i) {
    moveMouse(at->x + 20 + 3 * static_cast<float>(i), at->y);
    frame();
    EXPECT_TRUE(editor.session.changing());
  }
  EXPECT_GT(editor.session.level().camera.eye.x, opened.camera.eye.x);
  Level rest = editor.session.level();
  rest.camera.eye = opened.camera.eye;
  EXPECT_EQ(rest, opened) << "nothing but the eye";
  EXPECT_EQ(editor.session.level().camera.eye.y, opened.camera.eye.y);
  letGo();
  EXPECT_FALSE(editor.session.changing());
  EXPECT_EQ(steps(), 1);
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), opened);
}

TEST_F(NumberRow, EscRestoresAndEndsTheDrag) {
  const auto at = dragRow(eyeMovedInX);
  ASSERT_TRUE(at);
  EXPECT_TRUE(handleKey(keys::escape, 0, editor, ui));
  EXPECT_EQ(editor.session.level(), opened);
  frame();
  EXPECT_EQ(editor.session.level(), opened);
  for (int i = 1; i < 5; ++i) {
    moveMouse(at->x + 20 + 10 * static_cast<float>(i), at->y);
    frame();
    EXPECT_EQ(editor.session.level(), opened) << "the button is still down, but the drag is over";
  }
  letGo();
  EXPECT_FALSE(editor.session.canUndo());
  EXPECT_TRUE(dragRow(eyeMovedInX)) << "it can be dragged again";
}

TEST_F(NumberRow, UndoWhileItIsDraggedEndsTheDrag) {
  const auto at = dragRow(eyeMovedInX);
  ASSERT_TRUE(at);
  EXPECT_TRUE(handleKey('Z', keys::control, editor, ui));
  moveMouse(at->x + 60, at->y);
  frames(3);
  EXPECT_EQ(editor.session.level(), opened);
  letGo();
  EXPECT_FALSE(editor.session.canUndo());
}

TEST_F(NumberRow, ADragOfTheDepthScaleMeetsOne) {
  editor.selection = {Part::sculpture};
  frames(3);
  const auto at = dragRow([](const Level& before, const Level& now) {
    return before.sculpture.depthScale != now.sculpture.depthScale;
  });
  ASSERT_TRUE(at);
  const Rect& rect = ui.layout.properties;
  int ones = 0;
  for (float x = at->x; x < rect.x + rect.width; ++x) {
    moveMouse(x, at->y);
    frame();
    const double k = editor.session.level().sculpture.depthScale;
    ones += k == 1 ? 1 : 0;
    EXPECT_TRUE(k == 1 || std::abs(k - 1) > 0.03) << k;
  }
  EXPECT_GE(ones, 2) << "pixels";
  letGo();
}

TEST_F(NumberRow, CheckBoxIsOneStep) {
  editor.selection = {Part::sculpture};
  frames(3);
  const Rect& rect = ui.layout.properties;
  // From below, so that headings that fold leave what is above them in its place.
  for (float y = rect.y + rect.height - 4; y > rect.y + 70; y -= 5) {
    click(rect.x + 20, y);
    if (editor.session.level().sculpture.frozen) editor.session.undo();  // its button is below
    if (editor.session.level().sculpture.tolerancePixels != opened.sculpture.tolerancePixels) break;
    ASSERT_EQ(editor.session.level(), opened);
  }
  EXPECT_EQ(editor.session.level().sculpture.tolerancePixels, 0);
  EXPECT_EQ(steps(), 1);
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), opened);
}

class TypedNumber : public NumberRow {
 protected:
  static constexpr int enterCode = 257, escapeCode = 256;

  void SetUp() override {
    NumberRow::SetUp();
#if IMGUI_VERSION_NUM < 18700
    ImGui::GetIO().KeyMap[ImGuiKey_Enter] = enterCode;
    ImGui::GetIO().KeyMap[ImGuiKey_Escape] = escapeCode;
#endif
    const auto at = dragRow(eyeMovedInX);
    ASSERT_TRUE(at);
    letGo();
    editor.session.undo();
    Level level = editor.session.level();
    level.camera.eye.x = startX;
    editor.session.edit(level);
    opened = level;
    at_ = *at;
  }

  // A double click on the eye's x.
  void beginTyping() {
    moveMouse(at_.x, at_.y);
    frames(40);  // longer than a double click ago
    for (int i = 0; i < 2; ++i) {
      press(true);
      frame();
      press(false);
      frame();
    }
    frames(2);
    ASSERT_TRUE(ImGui::GetIO().WantTextInput);
  }
  void type(const std::string& text) {
    for (const char c : text) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned>(c));
      frame();
    }
  }
  void key([[maybe_unused]] int code) {
#if IMGUI_VERSION_NUM < 18700
    for (const bool down : {true, false}) {
      ImGui::GetIO().KeysDown[code] = down;
      frame();
    }
#else
    for (const bool down : {true, false}) {
      ImGui::GetIO().AddKeyEvent(code == enterCode ? ImGuiKey_Enter : ImGuiKey_Escape, down);
      frame();
    }
#endif
    frames(2);
  }
  void enter(const std::string& text) {
    beginTyping();
    type(text);
    key(enterCode);
  }

  double x() const {
    return editor.session.level().camera.eye.x;
  }

  static constexpr double startX = 0.123456;  // more digits than are shown
  ImVec2 at_;
};

TEST_F(TypedNumber, IsTakenAsOneStep) {
  const int before = steps();
  enter("-3.25");
  EXPECT_EQ(x(), -3.25);
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(TypedNumber, EscLeavesTheNumberWithAllItsDigits) {
  const int before = steps();
  beginTyping();
  type("7");
  key(escapeCode);
  EXPECT_EQ(x(), startX);
  EXPECT_EQ(steps(), before);
}

TEST_F(TypedNumber, TypedButNotChangedKeepsItsDigits) {
  const int before = steps();
  beginTyping();
  key(enterCode);
  EXPECT_EQ(x(), startX);
  EXPECT_EQ(steps(), before);
}

TEST_F(TypedNumber, StaysFiniteAndInItsRange) {
  for (const char* text :
       {"1e999", "-1e999", "*1e999", "/0", "/1e-999", "+1e308", "e", "", "-", "0", "*1e999", "*-1e999",
        "1e308", "999999999999999999999999999999", "--5", "1e", "..", "nan", "inf"}) {
    SCOPED_TRACE(text);
    enter(text);
    EXPECT_TRUE(std::isfinite(x())) << x();
    EXPECT_LE(std::abs(x()), 1e6);
  }
  while (editor.session.canUndo()) editor.session.undo();
  EXPECT_NE(x(), startX);
}

// A slider jumps to where it is clicked; a second click at once types.
TEST_F(NumberRow, ADoubleClickTypesIntoASlider) {
  openTab(ui.tabs, editor.selection, PropertyTab::eye);
  frames(2);
  const Rect& rect = ui.layout.properties;
  bool typed = false;
  for (float y = rect.y + 70; y < rect.y + rect.height && !typed; y += 5) {
    moveMouse(rect.x + 0.6f * rect.width, y);
    frames(30);  // not the second click of the last place
    const double fov = editor.session.level().camera.fovDegrees;
    for (const bool down : {true, false, true, false}) {
      press(down);
      frame(0.02);
    }
    const bool slider = editor.session.level().camera.fovDegrees != fov;
    if (slider) {
      EXPECT_TRUE(ImGui::GetIO().WantTextInput || ImGui::GetActiveID() != 0);
      typed = ImGui::GetActiveID() == ImGui::GetCurrentContext()->TempInputId && ImGui::GetActiveID() != 0;
      EXPECT_TRUE(typed);
    }
    letGoOfWidgets();
    frames(2);
  }
  EXPECT_TRUE(typed);
}

TEST_F(TypedNumber, IsAStepOfItsOwnBeforeADragOfTheGizmo) {
  const int before = steps();
  beginTyping();
  type("1.5");
  ASSERT_EQ(x(), 1.5);
  const Level typed = editor.session.level();
  const auto grip = gripOf(GizmoHandle::x);  // of the eye
  ASSERT_TRUE(grip);
  moveMouse(grip->x, grip->y);
  frames(2);
  press(true);
  frame();
  moveMouse(grip->x + 30, grip->y);
  frame();
  ASSERT_EQ(ui.mouse.drag, ViewDrag::gizmo);
  EXPECT_NE(editor.session.level(), typed);
  handleKey(keys::escape, 0, editor, ui);
  EXPECT_EQ(editor.session.level(), typed) << "Esc takes back the drag, not the number";
  letGo();
  EXPECT_EQ(steps(), before + 1);
}

class Menus : public PanelsTest {};

TEST_F(Menus, EscClosesThemAndKeepsTheSelection) {
  open("1-plane");
  editor.selection = {Part::mirror};
  frames(3);
  const auto isOpen = [] {
    return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  };
  for (int time = 0; time < 2; ++time) {
    click(ui.layout.menu.x + 30, ui.layout.menu.y + ui.layout.menu.height / 2);
    ASSERT_TRUE(isOpen());
    EXPECT_TRUE(handleKey(keys::escape, 0, editor, ui));
    frames(2);
    EXPECT_FALSE(isOpen());
    EXPECT_EQ(editor.selection.part, Part::mirror);
  }
  handleKey(keys::escape, 0, editor, ui);
  EXPECT_EQ(editor.selection.part, Part::none);
}

TEST_F(PanelsTest, ButtonsStandAMeshUpAndTurnIt) {
  open("1-plane");
  Level level = editor.session.level();
  level.original.shape = FileShape{std::string(ANAMORPH_TEST_DATA) + "/field/obj-y-up/house.obj"};
  editor.session.edit(level);
  editor.updater.finish(editor.session, {});
  editor.selection = {Part::original};
  ImGui::GetIO().DisplaySize.y = 2400;  // all of the tab is seen
  frames(3);
  std::set<std::string> done;
  const Rect& rect = ui.layout.properties;
  // From below: a click on a section's name folds it, and moves what is below.
  for (float y = rect.y + rect.height; y > rect.y && done.size() < 2; y -= 6) {
    click(rect.x + 0.5f * rect.width, y);
    letGo();
    const OriginalSettings& now = editor.session.level().original;
    if (std::get_if<FileShape>(&now.shape) && std::get<FileShape>(now.shape).up == ModelUp::y)
      done.insert("up");
    if (now.placement.rotationDegrees == Vector(0, 90, 0)) done.insert("turned about y");
    ui.browser.open = false;
    while (editor.session.canUndo()) editor.session.undo();
    editor.session.edit(level);
    editor.updater.finish(editor.session, {});
    frames(2);
  }
  EXPECT_EQ(done, (std::set<std::string>{"turned about y", "up"}));
}

// One with a problem has no middle that a plane could go through.
TEST_F(PanelsTest, OnlyASoundMirrorIsCutOff) {
  ImGui::GetIO().DisplaySize.y = 2400;  // all of the tab is seen
  for (const bool sound : {true, false}) {
    SCOPED_TRACE(sound);
    open("1-plane");
    Level level = editor.session.level();
    ExtrusionMirror wall;
    if (!sound) wall.points.resize(2);
    level.optic.shape() = wall;
    level.optic.shape().clipBy({{{0, 0, 1}, {0, 0, 1}}});  // so that the section is open
    editor.session.edit(level);
    editor.updater.finish(editor.session, {});
    editor.selection = {Part::mirror};
    frames(3);
    std::size_t cuts = 1;
    const Rect& rect = ui.layout.properties;
    for (float y = rect.y + rect.height; y > rect.y + 70 && cuts == 1; y -= 10) {
      click(rect.x + 0.5f * rect.width, y);
      letGo();
      for (const HalfSpace& half : editor.session.level().optic.shape().clip()) {
        EXPECT_TRUE(isFinite(half.point) && isFinite(half.normal)) << y;
      }
      cuts = std::max(cuts, editor.session.level().optic.shape().clip().size());
      ui.browser.open = false;
      editor.session.edit(level);
      frames(2);
    }
    EXPECT_EQ(cuts, sound ? 2u : 1u);
  }
}

class GizmoInTheView : public PanelsTest {};

TEST_F(GizmoInTheView, DragIsOneStepAndEscTakesItBack) {
  open("2-cylinder");
  const Level opened = editor.session.level();
  for (const bool keep : {true, false}) {
    editor.selection = {Part::original};
    frames(3);
    const auto grip = gripOf(GizmoHandle::x);
    ASSERT_TRUE(grip);
    moveMouse(grip->x, grip->y);
    frames(2);
    press(true);
    frame();
    for (int i = 1; i < 8; ++i) {
      moveMouse(grip->x + 5 * static_cast<float>(i), grip->y);
      frame();
    }
    EXPECT_NE(editor.session.level().original.placement.position, opened.original.placement.position);
    if (!keep) handleKey(keys::escape, 0, editor, ui);
    moveMouse(grip->x + 50, grip->y);
    frame();
    letGo();
    EXPECT_EQ(steps(), keep ? 1 : 0);
    editor.session.undo();
    EXPECT_EQ(editor.session.level(), opened);
  }
}

// Only the handle of k is left, on the ray, so that the construction can be seen.
TEST_F(GizmoInTheView, MakesRoomForAConstruction) {
  open("1-plane");
  editor.selection = {Part::original};
  frames(2);
  EXPECT_FALSE(currentGizmo(editor, ui).gizmo.empty());
  editor.point = PickedPoint{};
  frames(2);
  EXPECT_TRUE(currentGizmo(editor, ui).gizmo.empty());
  perform(Action::rotateMode, editor, ui);
  EXPECT_FALSE(editor.point) << "who wants to turn it wants the gizmo";
  EXPECT_FALSE(currentGizmo(editor, ui).gizmo.empty());
}

TEST_F(GizmoInTheView, TheHandleOfTheDepthScaleSitsOnTheRay) {
  open("1-plane");
  editor.selection = {Part::sculpture};
  editor.point = PickedPoint{};
  frames(2);
  const ViewProjection view(editor.pose, editor.viewWidth, editor.viewHeight);
  const Pixel start = *view.pixelOf(currentConstruction(editor)->ray.sculpture);
  const ImVec2 grip{ui.layout.view.x + static_cast<float>(start.x),
                    ui.layout.view.y + static_cast<float>(start.y)};
  VertexMap map = makeVertexMap(editor.session.level());
  map.depthScale = 0.6;
  const Pixel goal = *view.pixelOf(makeVertexRay(map, currentConstruction(editor)->ray.original).sculpture);
  moveMouse(grip.x, grip.y);
  frames(2);
  press(true);
  frame();
  ASSERT_EQ(ui.mouse.drag, ViewDrag::gizmo);
  moveMouse(ui.layout.view.x + static_cast<float>(goal.x), ui.layout.view.y + static_cast<float>(goal.y));
  frame();
  const double depthScale = editor.session.level().sculpture.depthScale;
  EXPECT_NEAR(depthScale, 0.6, 0.01);
  EXPECT_EQ(editor.status.text(), shownFormat("k = {:.2f}", depthScale));
  letGo();
}

TEST_F(GizmoInTheView, ASecondClickOnAVertexLetsItGo) {
  open("1-plane");
  frames(2);
  editor.display.sculpture = false;  // it may stand in front
  const ViewProjection view(editor.pose, editor.viewWidth, editor.viewHeight);
  const Pixel at = *view.pixelOf(originalBox(editor).centre());
  const float x = ui.layout.view.x + static_cast<float>(at.x),
              y = ui.layout.view.y + static_cast<float>(at.y);
  click(x, y);
  ASSERT_TRUE(editor.point);
  frames(30);  // no double click
  click(x, y);
  EXPECT_FALSE(editor.point);
  EXPECT_EQ(editor.selection, (Selection{Part::original}));
}

// With the ground shown a drag of the view ends at the floor, with it hidden it goes on.
TEST_F(PanelsTest, TheViewDoesNotGoBelowTheFloorByAccident) {
  for (const bool visible : {true, false}) {
    open("1-plane");
    Level level = editor.session.level();
    level.ground.visible = visible;
    editor.session.edit(level);
    frames(2);
    const float x = ui.layout.view.x + 30, y = ui.layout.view.y + ui.layout.view.height - 30;
    moveMouse(x, y);
    frames(2);
    press(true);
    frame();
    for (int i = 1; i <= 20; ++i) {
      moveMouse(x, y - 30 * static_cast<float>(i));
      frame();
    }
    letGo();
    if (visible) {
      EXPECT_GT(editor.pose.eye.z, 0);
      EXPECT_LT(editor.pose.eye.z, 1);
    } else {
      EXPECT_LT(editor.pose.eye.z, 0);
    }
  }
}

TEST_F(PanelsTest, ADigitBesideANumberIsNoKeyOfTheView) {
  open("1-plane");
  frames(2);
  const Rect& rows = ui.layout.properties;
  click(rows.x + 20, rows.y + 0.7f * rows.height);
  handleKey('0', 0, editor, ui);
  EXPECT_FALSE(editor.lookingThrough) << "who clicked there wanted to type";
  EXPECT_FALSE(editor.status.text().empty()) << "and is told how";
  moveMouse(ui.layout.view.x + 50, ui.layout.view.y + 50);
  frame();
  handleKey('0', 0, editor, ui);
  EXPECT_TRUE(editor.lookingThrough);
}

TEST_F(PanelsTest, AMessageWithoutRoomIsShownInFullUntilItIsRead) {
  open("1-plane");
  const auto window = [] { return ImGui::FindWindowByName("##long-message"); };
  editor.status.say("short");
  frames(2);
  EXPECT_FALSE(window());
  std::string message = "chess.obj: line 7: expected a face of three corners.";
  for (int i = 0; i < 5; ++i) message += " What can be done about it stands at the end.";
  editor.status.say(message);
  frames(3);
  ASSERT_TRUE(window() && window()->WasActive);
  click(window()->Pos.x + 20, window()->Pos.y + window()->Size.y - 16);
  EXPECT_EQ(editor.status.text(), "");
  frames(2);
  EXPECT_FALSE(window()->WasActive);
}

}  // namespace
}  // namespace anamorph::testing
