// Freezing by key and button, and what is shown alone: what the window says of it.

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include <chrono>
#include <thread>

#include "panels/help_buttons.h"
#include "panels_fixture.h"

namespace anamorph::testing {
namespace {

class FreezeInTheWindow : public PanelsTest {
 protected:
  FreezeInTheWindow() {
    open("2-cylinder");
    frames(2);
  }
  bool isFrozen() const { return editor.session.level().sculpture.frozen.has_value(); }
  static bool isSignShown() {
    const ImGuiWindow* window = ImGui::FindWindowByName("##signs");
    return window && window->Active;
  }
  void pressSignsButton() {
    const ImGuiWindow* window = ImGui::FindWindowByName("##signs");
    click(window->Pos.x + window->Size.x - 30, window->Pos.y + window->Size.y / 2);
  }
};

TEST_F(FreezeInTheWindow, ByKeyAndBackByTheSignInTheView) {
  EXPECT_FALSE(isSignShown());
  handleKey('P', 0, editor, ui);
  frames(2);
  EXPECT_TRUE(isFrozen());
  EXPECT_TRUE(isSignShown());
  EXPECT_TRUE(rowOf(Action::toggleFrozen).ticked(editor, ui));
  pressSignsButton();
  EXPECT_FALSE(isFrozen());
  frames(2);
  EXPECT_FALSE(isSignShown());
  perform(Action::undo, editor, ui);
  EXPECT_TRUE(isFrozen());
  perform(Action::undo, editor, ui);
  EXPECT_FALSE(isFrozen());
}

TEST_F(FreezeInTheWindow, NothingIsFrozenWhereThereIsNoSculpture) {
  Level level = editor.session.level();
  level.camera.eye = pointAt(level.optic.shape(), 0.3, 0.6);  // on the mirror
  editor.session.edit(level);
  editor.updater.finish(editor.session, {});
  EXPECT_FALSE(isEnabled(Action::toggleFrozen, editor, ui));
  perform(Action::toggleFrozen, editor, ui);
  EXPECT_FALSE(isFrozen());
}

TEST_F(FreezeInTheWindow, OneThingAloneIsShownUntilAskedAgain) {
  const std::pair<Action, ShownAlone> things[] = {{Action::originalAlone, ShownAlone::original},
                                                  {Action::sculptureAlone, ShownAlone::sculpture},
                                                  {Action::mirrorAlone, ShownAlone::mirror}};
  for (const auto& [action, thing] : things) {
    perform(action, editor, ui);
    frames(2);
    EXPECT_EQ(editor.display.alone, thing);
    EXPECT_TRUE(isSignShown());
    const DisplaySettings display = shown(editor.display);
    EXPECT_EQ(display.originalLook == OriginalLook::solid, thing == ShownAlone::original);
    EXPECT_EQ(display.sculpture, thing == ShownAlone::sculpture);
    EXPECT_EQ(display.mirror, thing == ShownAlone::mirror);
    EXPECT_FALSE(display.rtCamera || display.lightMarkers);
    for (const auto& [other, notThis] : things) EXPECT_EQ(rowOf(other).ticked(editor, ui), other == action);
  }
  perform(Action::mirrorAlone, editor, ui);
  EXPECT_EQ(shown(editor.display), editor.display);
  perform(Action::sculptureAlone, editor, ui);
  frames(2);
  pressSignsButton();
  EXPECT_EQ(editor.display.alone, ShownAlone::nothing);
  EXPECT_FALSE(editor.session.canUndo()) << "it is no edit";
}

TEST_F(FreezeInTheWindow, AHiddenMirrorIsSaidAndNotClicked) {
  // From where the mirror alone is under the middle of the view.
  editor.display.rtCamera = editor.display.lightMarkers = false;
  editor.display.sculpture = false;
  editor.display.originalLook = OriginalLook::hidden;
  const Box box = boxOf(editor.session.level().optic);
  editor.pose.target = box.centre();
  frames(2);
  const Pixel middle{0.5 * editor.viewWidth, 0.5 * editor.viewHeight};
  EXPECT_EQ(pickAt(editor, ui, middle).selection.part, Part::mirror);
  handleKey('H', 0, editor, ui);
  frames(2);
  EXPECT_TRUE(isSignShown());
  EXPECT_EQ(pickAt(editor, ui, middle).selection.part, Part::none);
  pressSignsButton();
  EXPECT_TRUE(editor.display.mirror);
  handleKey('H', 0, editor, ui);
  open("3-sphere");
  EXPECT_TRUE(editor.display.mirror) << "another level is seen whole";
}

TEST_F(FreezeInTheWindow, SearchesFindNothingForAFrozenSculpture) {
  perform(Action::toggleFrozen, editor, ui);
  const Level before = editor.session.level();
  for (void (*start)(Editor&) : {startFit, startBehind, startLift}) {
    start(editor);
    for (int i = 0; i < 2000 && editor.job.busy(); ++i) {
      frame();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(editor.session.level(), before);
  }
}

}  // namespace
}  // namespace anamorph::testing
