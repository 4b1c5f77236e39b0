#include "edit/lesson_run.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "edit/advance.h"
#include "edit/editor.h"
#include "edit/lesson_start.h"
#include "edit/level_edits.h"
#include "edit/orbit.h"
#include "lesson_levels.h"
#include "level/level_json.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

std::string step(const std::string& id, const std::string& done, const std::string& play = "",
                 const std::string& more = "") {
  const std::string show = play.empty() ? "{}" : "{\"play\": " + play + "}";
  return "{\"id\": \"" + id + R"(", "title": "T", "why": "W", "do": "D", "done": )" + done +
         ", \"show\": " + show + more + "}";
}

std::string startingWith(const std::string& start) {
  return ", \"start\": " + start;
}

// An editor with a small plane level and these steps, settled.
class LessonRunTest : public ::testing::Test {
 protected:
  void open(const std::string& steps) {
    Level level;
    std::get<BoxShape>(level.original.shape).segments = 2;
    level.sculpture.tolerancePixels = 1;
    level.text.edit([&](LevelText& text) {
      text.lesson = R"({"id": "test", "badge": {"title": "B", "text": ""}, "steps": [)" + steps + "]}";
    });
    folder_.save(level);
    openLevel(editor, folder_.path());
    editor.preview.size = 16;
    evaluate(editor);
  }
  void change(const std::function<void(Level&)>& how) {
    Level level = editor.session.level();
    how(level);
    editor.session.edit(level);
    evaluate(editor);
  }

  LessonFile folder_;
  Editor editor;
};

TEST_F(LessonRunTest, AMovedEyeCountsWhenTheDragEnds) {
  open(step("eye", R"([{"when": "movedEye"}])"));
  EXPECT_FALSE(editor.lesson.done);
  Level level = editor.session.level();
  level.camera.eye.x += 1;
  editor.session.change(level);
  advance(editor, 0.01);
  EXPECT_FALSE(editor.lesson.done) << "the drag goes on";
  editor.session.finishChange();
  advance(editor, 0.01);
  EXPECT_TRUE(editor.lesson.done);
  EXPECT_EQ(editor.progress, (LessonProgress{{"test", {"eye"}}}));
}

TEST_F(LessonRunTest, AStateThatAlreadyHoldsHasToBeLeftFirst) {
  open(step("on", R"([{"when": "toleranceOn"}])"));
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done);
  change([](Level& level) { level.sculpture.tolerancePixels = 0; });
  EXPECT_FALSE(editor.lesson.done);
  change([](Level& level) { level.sculpture.tolerancePixels = 0.5; });
  EXPECT_TRUE(editor.lesson.done);
}

TEST_F(LessonRunTest, AStateThatIsBroughtAlongCountsAtOnce) {
  open(step("look", "[]") + "," + step("off", R"([{"when": "toleranceOff"}])"));
  change([](Level& level) { level.sculpture.tolerancePixels = 0; });
  nextStep(editor);
  evaluate(editor);
  EXPECT_TRUE(editor.lesson.done);
}

TEST_F(LessonRunTest, AStateThatTheStepsOwnStartWouldHaveTakenBackIsNoneOfTheStudents) {
  open(step("look", "[]") + "," +
       step("on", R"([{"when": "toleranceOn"}])", "", startingWith(R"({"tolerance": "off"})")));
  nextStep(editor);  // with refinement on, as the level is
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done);
  EXPECT_TRUE(isStartMissed(editor.lesson, editor.session.level()));
  openStep(editor, 1);
  evaluate(editor);
  EXPECT_FALSE(isStartMissed(editor.lesson, editor.session.level()));
  change([](Level& level) { level.sculpture.tolerancePixels = 1; });
  EXPECT_TRUE(editor.lesson.done);
}

TEST_F(LessonRunTest, AnEventCountsOnlyWhileTheStepIsOpen) {
  open(step("first", "[]") + "," + step("look", R"([{"when": "lookedThrough"}])") + "," +
       step("eye", R"([{"when": "movedEye"}])") + "," + step("vertex", R"([{"when": "pickedVertex"}])"));
  toggleLookThrough(editor);
  evaluate(editor);
  change([](Level& level) { level.camera.eye.x += 1; });
  pickPoint(editor, PickedPoint{3, 1, 0});
  for (int i = 0; i < 3; ++i) {
    nextStep(editor);
    evaluate(editor);
    EXPECT_FALSE(editor.lesson.done) << editor.lesson.open().id;
  }
  pickPoint(editor, PickedPoint{5, 1, 0});
  evaluate(editor);
  EXPECT_TRUE(editor.lesson.done);
}

TEST_F(LessonRunTest, StatesHaveToHoldTogether) {
  open(step("free", R"([{"when": "keptEye"}, {"when": "depthScaleAbove", "value": 2}])"));
  change([](Level& level) { level.camera.eye.x += 1; });
  change([](Level& level) { level.sculpture.depthScale = 3; });
  EXPECT_FALSE(editor.lesson.done) << "the eye has gone";
  change([](Level& level) { level.camera.eye.x -= 1; });
  EXPECT_TRUE(editor.lesson.done);
}

TEST_F(LessonRunTest, BackAndAJumpRestoreWhatAStepBeginsWithAndNextDoesNot) {
  const auto startAt = [](double k) { return startingWith("{\"depthScale\": " + std::to_string(k) + "}"); };
  open(step("a", "[]") + "," + step("b", "[]", "", startAt(0.5)) + "," + step("c", "[]", "", startAt(2)));
  const Level file = editor.session.level();
  change([](Level& level) {
    level.sculpture.depthScale = 1.1;
    level.camera.eye.x += 1;
  });
  const Level own = editor.session.level();
  nextStep(editor);
  EXPECT_EQ(editor.session.level(), own);
  EXPECT_TRUE(isStartMissed(editor.lesson, editor.session.level()));
  nextStep(editor);
  previousStep(editor);
  Level wanted = file;
  wanted.sculpture.depthScale = 0.5;
  EXPECT_EQ(editor.session.level(), wanted);
  EXPECT_FALSE(isStartMissed(editor.lesson, editor.session.level()));
  EXPECT_FALSE(editor.status.text().empty()) << "it is said";
  openStep(editor, 0);
  EXPECT_EQ(editor.session.level(), file);
  editor.session.undo();
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), own) << "nothing is lost";
}

TEST_F(LessonRunTest, ALevelIsReopenedWithWhatTheStepBeginsWith) {
  editor.progress = {{"test", {"a"}}};
  open(step("a", "[]") + "," +
       step("b", R"([{"when": "depthScaleChanged"}])", "",
            startingWith(R"({"depthScale": 0.5, "preview": "wipe"})")));
  EXPECT_EQ(editor.lesson.step, 1u);
  EXPECT_EQ(editor.session.level().sculpture.depthScale, 0.5);
  EXPECT_EQ(editor.preview.tab, PreviewTab::wipe);
  EXPECT_FALSE(editor.session.modified() || editor.session.canUndo()) << "nobody has changed it";
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done);
}

TEST_F(LessonRunTest, NumbersThatAreNearEnoughAreNotOffered) {
  open(step("a", "[]") + "," +
       step("b", "[]", "", startingWith(R"({"depthScale": 0.5, "eye": [0, -12, 6], "tolerance": "off"})")));
  struct Case {
    double depthScale;
    Point eye;
    double tolerance;
    bool missed;
  };
  for (const Case& given :
       {Case{0.5, {0, -12, 6}, 0, false}, Case{0.45, {1, -11, 6}, 0, false}, Case{1, {0, -12, 6}, 0, true},
        Case{0.5, {0, -12, 12}, 0, true}, Case{0.5, {0, -12, 6}, 0.5, true}}) {
    openStep(editor, 0);
    change([&](Level& level) {
      level.sculpture.depthScale = given.depthScale;
      level.camera.eye = given.eye;
      level.sculpture.tolerancePixels = given.tolerance;
    });
    nextStep(editor);
    EXPECT_EQ(isStartMissed(editor.lesson, editor.session.level()), given.missed)
        << given.depthScale << " " << given.eye.z << " " << given.tolerance;
  }
}

TEST_F(LessonRunTest, AQuestionHasToBeAnsweredRight) {
  open(step("ask", R"([{"when": "movedEye"}])", R"({"eye": [1, -10, 5]})",
            R"(, "ask": {"text": "Q", "answers": [{"text": "A", "reply": "no"},
                {"text": "B", "reply": "yes", "right": true}]})"));
  change([](Level& level) { level.camera.eye.x += 1; });
  EXPECT_FALSE(editor.lesson.done);
  answerStep(editor, 0);
  evaluate(editor);
  EXPECT_FALSE(isAnswered(editor.lesson) || editor.lesson.done);
  answerStep(editor, 7);
  EXPECT_EQ(editor.lesson.answer, 0u) << "there is no such answer";
  answerStep(editor, 1);
  evaluate(editor);
  EXPECT_TRUE(isAnswered(editor.lesson) && editor.lesson.done);
  openStep(editor, 0);
  EXPECT_FALSE(isAnswered(editor.lesson)) << "asked anew";
  playStep(editor);
  EXPECT_TRUE(isAnswered(editor.lesson));
}

TEST_F(LessonRunTest, TwoVerticesAreShownAndTheirEndsTold) {
  open(step("ends", R"([{"when": "pickedEnds"}])"));
  const auto pick = [&](const Point& corner) {
    const Mesh& mesh = *editor.updater.result().original.mesh;
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
      if (glm::length(mesh.positions[i] - corner) < 1e-9) pickPoint(editor, pickedVertex(mesh, i));
    }
    evaluate(editor);
  };
  const Box box = originalBox(editor);
  pick(box.min);
  EXPECT_TRUE(currentConstruction(editor) && !earlierConstruction(editor));
  pick({box.min.x, box.min.y, box.max.z});
  EXPECT_FALSE(editor.lesson.done) << "of the same end";
  pick({box.max.x, box.min.y, box.min.z});
  EXPECT_TRUE(editor.lesson.done);
  EXPECT_EQ(currentConstruction(editor)->ray.original.x, box.max.x);
  EXPECT_EQ(earlierConstruction(editor)->ray.original.x, box.min.x);
  pickCell(editor, GridCell{1, 1});
  EXPECT_FALSE(editor.point || editor.earlierPoint) << "one pixel alone";
  pick(box.min);
  EXPECT_FALSE(editor.cell || editor.earlierPoint);
}

TEST_F(LessonRunTest, RaysStandStillInTheirStepOnly) {
  const auto pause = [&] {
    editor.rays.animate = editor.rays.sequential = editor.animationPaused = true;
    editor.animationSeconds = 3;
  };
  const auto rests = [&] {
    return editor.rays.animate || editor.rays.sequential || editor.animationPaused ||
           editor.animationSeconds != 0;
  };
  open(step("a", "[]") + "," + step("b", "[]"));
  pause();
  nextStep(editor);
  EXPECT_FALSE(rests());
  pause();
  previousStep(editor);
  EXPECT_FALSE(rests());
  pause();
  openLevel(editor, folder_.path());
  EXPECT_FALSE(rests());
}

TEST_F(LessonRunTest, FiguresThatAStepCanAskFor) {
  open(step("high", R"([{"when": "eyeAbove", "value": 9}])") + "," +
       step("away", R"([{"when": "eyeAway", "value": 30}])") + "," +
       step("k", R"([{"when": "depthScaleBelow", "value": 0.5}])") + "," +
       step("coarse", R"([{"when": "verticesBelow", "value": 9}])") + "," +
       step("wipe", R"([{"when": "wiped"}])"));
  const std::vector<std::function<void()>> moves{
      [&] { change([](Level& level) { level.camera.eye.z = 9.5; }); },
      [&] { change([](Level& level) { level.camera.eye.y = -40; }); },
      [&] { change([](Level& level) { level.sculpture.depthScale = 0.4; }); },
      [&] { change([](Level& level) { std::get<BoxShape>(level.original.shape).segments = 1; }); },
      [&] {
        editor.preview.tab = PreviewTab::wipe;
        editor.preview.wipe = 0.7;
        evaluate(editor);
      }};
  for (std::size_t i = 0; i < moves.size(); ++i) {
    openStep(editor, i);
    evaluate(editor);
    EXPECT_FALSE(editor.lesson.done) << editor.lesson.open().id;
    moves[i]();
    EXPECT_TRUE(editor.lesson.done) << editor.lesson.open().id;
  }
}

TEST_F(LessonRunTest, AViewIsTurnedWhenThatCanBeSeen) {
  open(step("turn", R"([{"when": "rotatedView"}])") + "," +
       step("down", R"([{"when": "lookedDown", "value": 40}])"));
  const auto turn = [&](double sideways, double down) {
    editor.pose = orbit(editor.pose, sideways / orbitDegreesPerPixel, down / orbitDegreesPerPixel);
    advance(editor, 0.01);
    return editor.lesson.done;
  };
  EXPECT_FALSE(turn(15, 0)) << "a twitch of the mouse";
  EXPECT_TRUE(turn(15, 0));
  nextStep(editor);
  EXPECT_FALSE(turn(120, 0)) << "sideways one never looks down";
  EXPECT_TRUE(turn(0, 40));
}

TEST_F(LessonRunTest, WhatAConditionSaysOfTheLevelIsNotKnownInADrag) {
  open(step("on", R"([{"when": "toleranceOn"}])"));
  Level level = editor.session.level();
  level.camera.eye.x += 1;
  editor.session.change(level);
  const auto held = holds({StepEvent::toleranceOn, 0, {}}, editor.lesson.begin, editor);
  EXPECT_EQ(held, std::nullopt);
  editor.session.finishChange();
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done) << "it held before, and nobody has touched it";
}

TEST_F(LessonRunTest, DoItSaysSoWhereTheOriginalIsAnotherOne) {
  const std::string corner = R"([{"when": "pickedVertex"}])",
                    coarse = R"([{"when": "verticesBelow", "value": 9}])";
  open(step("vertex", corner, R"({"vertex": 5})") + "," + step("ends", corner, R"({"ends": [0, 5]})") + "," +
       step("coarse", coarse, R"({"segments": 1})"));
  for (std::size_t i = 0; i < 3; ++i) {
    SCOPED_TRACE(i);
    openStep(editor, i);
    evaluate(editor);
    editor.status.clear();
    change([](Level& level) { level.original.shape = PawnShape{}; });
    EXPECT_TRUE(pointsOfMove(editor).empty());
    playStep(editor);
    EXPECT_FALSE(editor.lesson.play || editor.point) << "another vertex has that number";
    EXPECT_FALSE(editor.status.text().empty());
    openStep(editor, i);
    evaluate(editor);
    EXPECT_EQ(pointsOfMove(editor).size(), i == 0 ? 1u : i == 1 ? 2u : 0u);
    playStep(editor);
    EXPECT_TRUE(editor.lesson.play);
    finishPlay(editor);
  }
}

TEST_F(LessonRunTest, TheMatchIsJudgedWhenItIsSettled) {
  open(step("worse", R"([{"when": "matchBelow", "value": 0.9}])") + "," +
       step("better", R"([{"when": "matchAbove", "value": 0.99}])"));
  EXPECT_FALSE(editor.lesson.done);
  const Level right = editor.session.level();
  change([](Level& level) {
    level.optic.shape() = PlaneMirror{{Point(-8, 0, 0), Point(0, 0, 0), Point(0, 0, 8), Point(-8, 0, 8)}};
  });
  EXPECT_TRUE(editor.lesson.done);
  nextStep(editor);
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done);
  editor.session.edit(right);
  evaluate(editor);
  EXPECT_TRUE(editor.lesson.done);
  EXPECT_TRUE(scoreOf(editor.lesson.lesson, editor.progress).badge);
}

TEST_F(LessonRunTest, AProblemIsNoMatch) {
  open(step("worse", R"([{"when": "matchBelow", "value": 0.5}])"));
  change([](Level& level) { level.camera.eye = {0, 0, 1}; });  // in the mirror's plane
  ASSERT_TRUE(editor.updater.result().problem);
  EXPECT_TRUE(editor.lesson.done);
}

TEST_F(LessonRunTest, WhereNothingIsSeenNothingIsDoneByHidingNothing) {
  open(step("free", R"([{"when": "hiddenShareBelow", "value": 0}, {"when": "movedEye"}])"));
  change([](Level& level) { level.sculpture.depthScale = 0.5; });
  ASSERT_GT(editor.updater.result().match->report.hiddenShare, 0);
  change([](Level& level) { level.camera.eye = {0, 0, 1}; });  // in the mirror's plane
  EXPECT_FALSE(editor.lesson.done);
  change([](Level& level) { level.camera.target = level.camera.eye + Vector(0, -1, 0); });
  EXPECT_FALSE(editor.lesson.done);
}

TEST_F(LessonRunTest, IsThatOfTheLevelThatWasPasted) {
  open(step("first", R"([{"when": "movedEye"}])"));
  const std::string own = editor.session.level().text->lesson;
  change([&](Level& level) {
    level.text.edit([&](LevelText& text) {
      text.lesson = R"({"id": "other", "badge": {"title": "B", "text": ""}, "steps": [)" +
                    step("pasted", R"([{"when": "undone"}])") + "]}";
    });
  });
  EXPECT_EQ(editor.lesson.lesson.id, "other");
  editor.session.undo();
  evaluate(editor);
  EXPECT_EQ(editor.lesson.lesson.id, "test");
  EXPECT_EQ(editor.session.level().text->lesson, own);
}

TEST_F(LessonRunTest, SeveralConditionsMayComeInAnyOrder) {
  open(step("both", R"([{"when": "viewed", "what": "difference"}, {"when": "depthScaleChanged"}])"));
  change([](Level& level) { level.sculpture.depthScale = 2; });
  change([](Level& level) { level.sculpture.depthScale = 1; });
  EXPECT_FALSE(editor.lesson.done);
  editor.preview.tab = PreviewTab::difference;
  advance(editor, 0.01);
  EXPECT_TRUE(editor.lesson.done) << "the depth scale had been changed, though it is back";
}

TEST_F(LessonRunTest, NextLeavesTheRtCameraWhereSomethingIsToBeDoneInTheView) {
  const std::string inView =
      R"({"id": "b", "title": "T", "why": "W", "do": "D", "done": [{"when": "pickedVertex"}],
                                 "show": {"play": {"vertex": 3}}})";
  open(step("a", R"([{"when": "lookedThrough"}])") + "," + step("between", "[]") + "," + inView);
  toggleLookThrough(editor);
  nextStep(editor);
  EXPECT_TRUE(editor.lookingThrough) << "nothing speaks against it";
  nextStep(editor);
  EXPECT_FALSE(editor.lookingThrough) << "there a click takes a pixel, not a vertex";
}

TEST_F(LessonRunTest, AStepThatIsOnlyReadIsDoneByNext) {
  open(step("read", "[]") + "," + step("eye", R"([{"when": "movedEye"}])"));
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done);
  nextStep(editor);
  EXPECT_EQ(editor.lesson.step, 1u);
  EXPECT_EQ(editor.progress["test"].count("read"), 1u);
  nextStep(editor);
  EXPECT_EQ(editor.lesson.step, 1u) << "the last";
  EXPECT_EQ(editor.progress["test"].count("eye"), 0u) << "skipping is not doing";
  previousStep(editor);
  previousStep(editor);
  EXPECT_EQ(editor.lesson.step, 0u);
  EXPECT_TRUE(editor.lesson.done) << "once done, always done";
}

TEST_F(LessonRunTest, ALevelOpensWhereTheStudentLeftOff) {
  editor.progress = {{"test", {"a", "c"}}};
  open(step("a", "[]") + "," + step("b", "[]") + "," + step("c", "[]"));
  EXPECT_EQ(editor.lesson.step, 1u);
  editor.progress["test"].insert("b");
  openLevel(editor, folder_.path());
  advance(editor, 0.01);
  EXPECT_EQ(editor.lesson.step, 0u) << "all are done";
}

TEST_F(LessonRunTest, AStepThatWasDoneBeforeIsObservedAnew) {
  editor.progress = {{"test", {"eye"}}};
  open(step("eye", R"([{"when": "movedEye"}])"));
  EXPECT_TRUE(editor.lesson.done);
  EXPECT_FALSE(editor.lesson.doneNow) << "for an audience it is to be done";
  change([](Level& level) { level.camera.eye.x += 1; });
  EXPECT_TRUE(editor.lesson.doneNow);
}

TEST_F(LessonRunTest, PointsAndBadge) {
  open(step("a", "[]") + "," + step("b", "[]") +
       ",{\"id\": \"c\", \"title\": \"\", \"why\": \"\", \"do\": \"\", \"optional\": true}");
  const Lesson& lesson = editor.lesson.lesson;
  const auto score = [&](std::set<std::string> done) { return scoreOf(lesson, {{"test", std::move(done)}}); };
  EXPECT_EQ(score({}).points, 0);
  EXPECT_EQ(score({}).of, 25);
  EXPECT_EQ(score({"a", "c"}).points, 15);
  EXPECT_FALSE(score({"a", "c"}).badge);
  EXPECT_TRUE(score({"a", "b"}).badge);
  EXPECT_EQ(score({"a", "b", "of an older version"}).done, 2u);
}

TEST_F(LessonRunTest, ShowMeMovesWithinASecondOrTwoAndIsOneStepBack) {
  open(step("eye", R"([{"when": "movedEye"}])", R"({"eye": [1, -10, 5], "depthScale": 0.5, "morph": 0.25})"));
  const Level before = editor.session.level();
  playStep(editor);
  EXPECT_TRUE(isMoving(editor));
  advance(editor, 1.4);
  const Point between = editor.session.level().camera.eye;
  EXPECT_GT(between.x, 0);
  EXPECT_LT(between.x, 1);
  EXPECT_FALSE(editor.lesson.done);
  double lowest = 1;
  for (int i = 0; i < 200 && editor.lesson.play; ++i) {
    advance(editor, 0.05);
    lowest = std::min(lowest, editor.display.morph);
  }
  EXPECT_EQ(editor.session.level().camera.eye, Point(1, -10, 5));
  EXPECT_EQ(editor.session.level().sculpture.depthScale, 0.5);
  EXPECT_NEAR(lowest, 0.25, 0.01);
  EXPECT_EQ(editor.display.morph, 1) << "there and back";
  EXPECT_TRUE(editor.lesson.done);
  editor.session.undo();
  EXPECT_TRUE(editor.session.level() == before);
}

TEST_F(LessonRunTest, AHandOnTheLevelEndsTheShow) {
  open(step("eye", R"([{"when": "movedEye"}])", R"({"eye": [1, -10, 5]})"));
  playStep(editor);
  advance(editor, 0.3);
  Level level = editor.session.level();
  level.camera.eye = {-3, -9, 4};
  editor.session.change(level);
  advance(editor, 0.3);
  EXPECT_FALSE(editor.lesson.play);
  EXPECT_EQ(editor.session.level().camera.eye, Point(-3, -9, 4));
}

TEST_F(LessonRunTest, AMoveMakesABoxCoarserAndNothingElse) {
  open(step("eight", R"([{"when": "changedOriginal"}])", R"({"segments": 1})") + "," +
       step("pawn", "[]", R"({"shape": "pawn", "segments": 1})"));
  const BoxShape before = std::get<BoxShape>(editor.session.level().original.shape);
  playStep(editor);
  evaluate(editor);
  const BoxShape after = std::get<BoxShape>(editor.session.level().original.shape);
  EXPECT_EQ(after.segments, 1);
  EXPECT_EQ(after.size, before.size);
  EXPECT_TRUE(editor.lesson.done);
  nextStep(editor);
  playStep(editor);
  evaluate(editor);
  EXPECT_EQ(std::get<PawnShape>(editor.session.level().original.shape), PawnShape{});
}

TEST_F(LessonRunTest, EveryPartOfAMove) {
  open(step("all", "[]",
            R"({"original": [1, 4, 1], "mirror": [0, 0.5, 4], "fovDegrees": 30, "tolerance": "off",
       "viewEye": [9, -9, 9], "viewTarget": [0, 0, 1], "vertex": 3, "pixel": [2, 5], "preview": "wipe",
       "rays": "pixels", "shape": "pawn", "animate": true, "wireframe": true})"));
  playStep(editor);
  finishPlay(editor);
  for (int i = 0; i < 30; ++i) advance(editor, 0.1);
  const Level& level = editor.session.level();
  EXPECT_EQ(level.original.placement.position, Point(1, 4, 1));
  EXPECT_LT(glm::length(middleOf(level.optic.shape()) - Point(0, 0.5, 4)), 1e-12);
  EXPECT_EQ(level.camera.fovDegrees, 30);
  EXPECT_EQ(level.sculpture.tolerancePixels, 0);
  EXPECT_TRUE(std::holds_alternative<PawnShape>(level.original.shape));
  EXPECT_EQ(editor.pose.eye, Point(9, -9, 9));
  EXPECT_FALSE(editor.point) << "the pixel, which comes last, is alone";
  EXPECT_EQ(editor.cell, (GridCell{2, 5}));
  EXPECT_EQ(editor.preview.tab, PreviewTab::wipe);
  EXPECT_EQ(editor.rays.source, RaySource::pixels);
  EXPECT_TRUE(editor.rays.animate && editor.display.wireframe);
}

}  // namespace
}  // namespace anamorph
