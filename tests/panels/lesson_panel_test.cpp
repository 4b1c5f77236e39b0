// The lesson in the window: its buttons, its presenter, the tour, and that "where?" points at controls that
// are there.

#include <string>

#include <gtest/gtest.h>

#include "edit/lesson_run.h"
#include "panels/lesson_text.h"
#include "panels/widgets.h"
#include "panels_fixture.h"

namespace anamorph::testing {
namespace {

class LessonPanelTest : public PanelsTest {
 protected:
  // A lesson without a level's file: three steps, the first only read.
  void openLesson() {
    open("1-plane");
    frame();
    editor.lesson.lesson = parseLesson(R"({"id": "t", "badge": {"title": "B", "text": "C"}, "steps": [
      {"id": "a", "title": "A", "why": "W", "do": "D", "notice": "N", "figure": "construction"},
      {"id": "b", "title": "B", "why": "W", "do": "D", "done": [{"when": "depthScaleChanged"}],
       "show": {"tab": "sculpture", "widget": "Depth scale k", "play": {"depthScale": 0.5}}},
      {"id": "c", "title": "C", "why": "W", "do": "D", "optional": true, "done": [{"when": "undone"}]}]})",
                                       "t");
    openStep(editor, 0);
    frames(3);
  }
  // The lower right button of the lesson: on to the next step.
  void clickOn() {
    const Rect& r = ui.layout.lesson;
    click(r.x + 0.75f * r.width, r.y + r.height - 24);
  }
};

TEST_F(LessonPanelTest, NextReadsAndSkips) {
  openLesson();
  clickOn();
  EXPECT_EQ(editor.lesson.step, 1u);
  EXPECT_EQ(editor.progress["t"].count("a"), 1u);
  clickOn();
  EXPECT_EQ(editor.lesson.step, 2u);
  EXPECT_EQ(editor.progress["t"].count("b"), 0u);
}

TEST_F(LessonPanelTest, WhereOpensTheTabAndPointsAndDoesNothing) {
  openLesson();
  openStep(editor, 1);
  frames(2);
  const Level before = editor.session.level();
  const int outlined = ui.highlight.outlined;
  handleKey('M', keys::shift, editor, ui);
  frames(30);
  EXPECT_EQ(ui.tabs.open, PropertyTab::sculpture);
  EXPECT_GT(ui.highlight.outlined, outlined);
  EXPECT_EQ(editor.session.level(), before);
  EXPECT_FALSE(editor.lesson.done || editor.lesson.play);
}

TEST_F(LessonPanelTest, WhatIsFoldedIsUnfoldedToBePointedAt) {
  openLesson();
  const int before = ui.highlight.outlined;
  startHighlight(ui.highlight, "Shininess", editor.lesson);  // of a section that is folded in the beginning
  openTab(ui.tabs, editor.selection, PropertyTab::sculpture);
  frames(6);
  EXPECT_GT(ui.highlight.outlined, before);
}

TEST_F(LessonPanelTest, ALevelThatDoesNotFitIsOfferedToBeSetUp) {
  openLesson();
  editor.lesson.lesson.steps[1].start.depthScale = 0.2;
  nextStep(editor);
  frames(2);
  EXPECT_NE(editor.session.level().sculpture.depthScale, 0.2);
  perform(Action::restartStep, editor, ui);
  frames(2);
  EXPECT_EQ(editor.session.level().sculpture.depthScale, 0.2);
}

TEST_F(LessonPanelTest, ShowMeOpensTheTabPointsAndMoves) {
  openLesson();
  openStep(editor, 1);
  frames(2);
  const int before = ui.highlight.outlined;
  handleKey('M', 0, editor, ui);
  frames(3);
  EXPECT_EQ(ui.tabs.open, PropertyTab::sculpture);
  EXPECT_GT(ui.highlight.outlined, before);
  for (int i = 0; i < 100 && editor.lesson.play; ++i) frame(0.05);
  EXPECT_EQ(editor.session.level().sculpture.depthScale, 0.5);
  frames(2);
  EXPECT_TRUE(editor.lesson.done);
  EXPECT_TRUE(ui.highlight.control.empty()) << "it stops pointing when the move is made";
}

TEST_F(LessonPanelTest, WherePointsForAWhileOnly) {
  openLesson();
  openStep(editor, 1);
  handleKey('M', keys::shift, editor, ui);
  for (int i = 0; i < 30; ++i) frame(0.1);
  EXPECT_FALSE(ui.highlight.control.empty());
  for (int i = 0; i < 100; ++i) frame(0.1);
  EXPECT_TRUE(ui.highlight.control.empty());
}

TEST_F(LessonPanelTest, WhatShowMeDidIsOneStepBack) {
  openLesson();
  openStep(editor, 1);
  const Level before = editor.session.level();
  handleKey('M', 0, editor, ui);
  for (int i = 0; i < 200 && (i < 3 || editor.lesson.play); ++i) frame(0.02);
  ASSERT_EQ(editor.session.level().sculpture.depthScale, 0.5);
  EXPECT_EQ(steps(), 1);
  perform(Action::undo, editor, ui);
  EXPECT_EQ(editor.session.level(), before);
}

TEST_F(LessonPanelTest, WhatIsPointedAtIsOfTheOpenStepOnly) {
  openLesson();
  openStep(editor, 1);
  frames(2);
  handleKey('M', 0, editor, ui);
  frames(3);
  EXPECT_EQ(ui.highlight.control, "Depth scale k");
  handleKey(keys::right, keys::alt, editor, ui);
  frames(2);
  EXPECT_EQ(ui.highlight.control, "");
}

TEST_F(LessonPanelTest, KeysStepAndThePresenterTakesArrows) {
  openLesson();
  handleKey(keys::right, 0, editor, ui);
  EXPECT_EQ(editor.lesson.step, 0u) << "not presenting";
  handleKey(keys::right, keys::alt, editor, ui);
  EXPECT_EQ(editor.lesson.step, 1u);
  handleKey(keys::f3, 0, editor, ui);
  frames(3);
  EXPECT_TRUE(ui.presenting && ui.panelsHidden);
  EXPECT_FALSE(ui.layout.preview.empty()) << "steps ask for it";
  EXPECT_GT(ui.layout.words.height, 50);
  EXPECT_EQ(ui.layout.view.height + ui.layout.words.height, 800) << "nothing of the view is covered";
  handleKey(keys::right, 0, editor, ui);
  EXPECT_EQ(editor.lesson.step, 2u);
  handleKey(keys::left, 0, editor, ui);
  EXPECT_EQ(editor.lesson.step, 1u);
  frames(3);
  handleKey(keys::f3, 0, editor, ui);
  EXPECT_FALSE(ui.presenting || ui.panelsHidden);
}

TEST_F(LessonPanelTest, TheTourWaitsForItsReaderAndCanBeSkipped) {
  openLesson();
  perform(Action::tour, editor, ui);
  for (int i = 0; i < 1000; ++i) frame(0.1);
  EXPECT_EQ(ui.tour.card, 0);
  handleKey(keys::escape, 0, editor, ui);
  EXPECT_EQ(ui.tour.card, -1);
  EXPECT_TRUE(ui.preferences.tourSeen);
}

TEST_F(LessonPanelTest, TheTourLeavesOutWhatASmallWindowHasNot) {
  openLesson();
  ImGui::GetIO().DisplaySize = {320, 200};
  perform(Action::tour, editor, ui);
  ui.tour.card = 1;  // the view is all that is left
  frames(10);
  EXPECT_EQ(ui.tour.card, -1);
}

TEST_F(LessonPanelTest, TheLevelListGivesItsRoomToALessonUntilItIsUnfolded) {
  openLesson();
  frames(2);
  EXPECT_TRUE(ui.layout.levelsFolded);
  const float folded = ui.layout.lesson.height;
  click(ui.layout.left.x + 40, ui.layout.left.y + ui.layout.left.height / 2);
  EXPECT_FALSE(ui.layout.levelsFolded);
  EXPECT_LT(ui.layout.lesson.height, folded - 150);
}

TEST_F(LessonPanelTest, ProgressIsForgottenOnlyWhenAskedTwice) {
  openLesson();
  nextStep(editor);
  perform(Action::progress, editor, ui);
  frames(3);
  EXPECT_TRUE(ui.progress.open);
  EXPECT_FALSE(editor.progress.empty());
  ui.progress.resetAsked = true;
  frames(3);
  EXPECT_FALSE(editor.progress.empty());
  handleKey(keys::escape, 0, editor, ui);
  frames(2);
  EXPECT_FALSE(ui.progress.open || ui.progress.resetAsked);
}

TEST_F(LessonPanelTest, EveryInstalledStepIsDrawnAtEveryScaleAndPointsAtAControlThatIsThere) {
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    open(entry.name);
    frame();
    for (std::size_t i = 0; i < editor.lesson.lesson.steps.size(); ++i) {
      SCOPED_TRACE(entry.name + " step " + std::to_string(i + 1));
      openStep(editor, i);
      for (const double scale : {0.75, 1.0, 2.0}) {
        setLook(Theme::projector, scale);
        frames(2);
      }
      setLook(Theme::dark, 1);
      const StepShow show = editor.lesson.open().show;
      if (show.widget.empty()) continue;
      const int before = ui.highlight.outlined;
      pointAtStep(editor, ui);
      frames(6);
      EXPECT_GT(ui.highlight.outlined, before) << show.widget;
      doStep(editor, ui);
      frames(2);
      finishPlay(editor);
      frames(2);
    }
  }
}

}  // namespace
}  // namespace anamorph::testing
