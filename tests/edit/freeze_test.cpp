// Freezing in the window: by undo and redo, within a drag, and for the lessons.

#include "level/freeze.h"

#include <gtest/gtest.h>

#include <string>

#include "edit/advance.h"
#include "edit/editor.h"
#include "edit/gizmo.h"
#include "edit/lesson_run.h"
#include "edit/level_edits.h"
#include "edit/replacements.h"
#include "geometry/shapes.h"
#include "lesson_levels.h"
#include "pipeline/changing_levels.h"

namespace anamorph {
namespace {

using namespace testing;

class Freezing : public ::testing::TestWithParam<unsigned> {
 protected:
  void SetUp() override {
    file_.save(quickLevels()[GetParam() % 3]);
    openLevel(editor_, file_.path());
    editor_.preview.size = 32;
    evaluate(editor_);
  }
  const LevelResult& result() const { return editor_.updater.result(); }
  const Mesh& sculpture() const { return result().sculpture.sculpture->mesh; }
  void drag(int frames) {
    for (int i = 0; i < frames; ++i) {
      editor_.session.change(changed(editor_.session.level(), random_, 0.1));
      advance(editor_, 0.01);
    }
  }
  /// All as it is made of the level when nothing has gone before.
  void expectAsAfresh() {
    evaluate(editor_);
    const LevelResult afresh =
        *Evaluator().evaluate({editor_.session.level(), editor_.session.path(), 32}, 2);
    EXPECT_EQ(sculpture(), afresh.sculpture.sculpture->mesh);
    EXPECT_EQ(*result().source, *afresh.source);
    EXPECT_EQ(result().problem, afresh.problem);
    ASSERT_EQ(result().match == nullptr, afresh.match == nullptr);
    if (afresh.match) {
      EXPECT_EQ(result().match->classes, afresh.match->classes);
      EXPECT_EQ(result().match->report.p99Px, afresh.match->report.p99Px);
    }
  }

  LessonFile file_;
  Editor editor_{{}, 2};
  Random random_{GetParam()};
};

TEST_P(Freezing, CostsNothingAndChangesNothing) {
  const PreparedSculpture before = result().sculpture;
  const auto match = result().match;
  toggleFrozen(editor_);
  EXPECT_TRUE(editor_.session.level().sculpture.frozen);
  evaluate(editor_);
  EXPECT_EQ(result().sculpture, before) << "the same object";
  EXPECT_EQ(result().match->classes, match->classes);
  EXPECT_TRUE(result().refined && result().complete);
}

TEST_P(Freezing, EveryFrameOfADragLeavesEveryVertex) {
  toggleFrozen(editor_);
  const Mesh before = sculpture();
  const LiveCounts counts = editor_.updater.liveCounts();
  drag(12);
  EXPECT_EQ(sculpture(), before);
  EXPECT_EQ(editor_.updater.liveCounts().sculptures, counts.sculptures) << "nor is one mapped";
  editor_.session.finishChange();
  expectAsAfresh();
  EXPECT_EQ(sculpture(), before);
  toggleFrozen(editor_);
  EXPECT_FALSE(editor_.session.level().sculpture.frozen);
  expectAsAfresh();
}

TEST_P(Freezing, IsUndoneAndDoneAgainLikeAnyEdit) {
  const Level start = editor_.session.level();
  toggleFrozen(editor_);
  const Mesh kept = sculpture();
  drag(3);
  editor_.session.finishChange();
  const Level moved = editor_.session.level();
  toggleFrozen(editor_);
  evaluate(editor_);
  editor_.session.undo();  // it is frozen again, though the original stands elsewhere
  EXPECT_EQ(editor_.session.level(), moved);
  expectAsAfresh();
  EXPECT_EQ(sculpture(), kept);
  editor_.session.undo();
  editor_.session.undo();
  EXPECT_EQ(editor_.session.level(), start);
  expectAsAfresh();
  for (int i = 0; i < 3; ++i) {
    editor_.session.redo();
    expectAsAfresh();
  }
  EXPECT_EQ(editor_.session.level(), following(moved));
}

INSTANTIATE_TEST_SUITE_P(Seeds, Freezing, ::testing::Range(0u, 6u));

TEST(FrozenEdits, ChangeNothingOfTheSculpture) {
  const Level level = frozen(quickLevels()[1]);
  const Selection sculpture{Part::sculpture};
  for (const GizmoMode mode : {GizmoMode::move, GizmoMode::rotate, GizmoMode::scale})
    EXPECT_FALSE(allows(level, sculpture, mode));
  EXPECT_TRUE(allows(following(level), sculpture, GizmoMode::scale));
  EXPECT_EQ(scaled(level, sculpture, Point(0), Vector(2)), level);
}

TEST(FrozenEdits, AnotherOriginalIsFollowed) {
  const Level level = frozen(quickLevels()[0]);
  EXPECT_FALSE(withBuiltInOriginal(level, 1, {{-1, 3, 0}, {1, 5, 2}}).sculpture.frozen);
}

TEST(FrozenEdits, TheVertexRayIsTheOneThatTheVertexWasMadeBy) {
  LessonFile file;
  file.save(quickLevels()[0]);
  Editor editor{{}, 2};
  openLevel(editor, file.path());
  evaluate(editor);
  toggleFrozen(editor);
  editor.point = PickedPoint{0, 0, 0};
  const auto before = currentConstruction(editor);
  ASSERT_TRUE(before);
  Level level = editor.session.level();
  level.camera.eye.x += 2;
  level.original.placement.position.x += 1;
  editor.session.edit(level);
  evaluate(editor);
  const auto after = currentConstruction(editor);
  ASSERT_TRUE(after);
  EXPECT_EQ(after->points.front().at, before->points.front().at) << "E";
  EXPECT_EQ(after->distances.back().text, before->distances.back().text) << "k d";
  EXPECT_EQ(after->distances.back().at, before->distances.back().at);
}

TEST(FrozenEdits, AnotherMeshInAMeshFilesPlaceLetsItFollow) {
  Level level = quickLevels()[0];
  level.original.shape = FileShape{"a.obj"};
  level = frozen(level);
  const Mesh mesh = makeBox(Vector(1), 1);
  EXPECT_FALSE(
      withAnotherMesh(level, FileShape{"b.obj"}, mesh, boundingBox(mesh.positions)).sculpture.frozen);
}

TEST(FrozenStep, IsDoneWhenItWasFrozenTheEyeMovedAndTheMatchFell) {
  LessonFile file;
  Level level = quickLevels()[1];
  level.text.edit([](LevelText& text) {
    text.lesson =
        R"({"id": "l", "steps": [{"id": "a", "title": "T", "why": "W", "do": "D",
            "done": [{"when": "frozen"}, {"when": "movedEye"}, {"when": "matchBelow", "value": 0.9}],
            "show": {"play": {"freeze": true, "depthScale": 0.3, "eye": [4, -9.1, 9.6]}}}]})";
  });
  file.save(level);
  Editor editor{{}, 2};
  openLevel(editor, file.path());
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done);
  level = editor.session.level();  // with the lesson's words as they were read
  level.camera.eye.x += 4;
  editor.session.edit(level);
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done) << "the sculpture has followed";
  toggleFrozen(editor);
  evaluate(editor);
  EXPECT_FALSE(editor.lesson.done) << "it is right still";
  level = editor.session.level();
  level.camera.eye.x -= 4;
  editor.session.edit(level);
  evaluate(editor);
  EXPECT_TRUE(editor.lesson.done);
  editor.progress.clear();
  editor.session.edit(following(editor.session.level()));
  openStep(editor, 0);
  evaluate(editor);
  playStep(editor);
  evaluate(editor);
  EXPECT_TRUE(editor.lesson.done) << "shown";
  EXPECT_EQ(editor.session.level().sculpture.frozen->depthScale, 0.3) << "the move's, before it was frozen";
}

}  // namespace
}  // namespace anamorph
