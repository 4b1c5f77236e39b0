#include "edit/session.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

const std::filesystem::path levels = ANAMORPH_LEVELS;
const std::filesystem::path scenes = std::filesystem::path(ANAMORPH_TEST_DATA) / "scenes";

Level numbered(int number) {
  Level level;
  level.sculpture.depthScale = 1 + number;
  return level;
}

/// What a history is: a list of levels, a place in it, perhaps a change that goes on.
class Model {
 public:
  explicit Model(const Level& level) : steps_{level} {}

  const Level& level() const { return change_ ? *change_ : steps_[at_]; }
  bool changing() const { return change_.has_value(); }
  bool canUndo() const { return changing() || at_ > 0; }
  bool canRedo() const { return !changing() && at_ + 1 < steps_.size(); }

  void change(const Level& level) { change_ = level; }
  void finish() {
    if (change_ && !(*change_ == steps_[at_])) {
      steps_.resize(at_ + 1);
      steps_.push_back(*change_);
      ++at_;
    }
    change_.reset();
  }
  void cancel() { change_.reset(); }
  void undo() {
    if (changing()) return cancel();
    if (at_ > 0) --at_;
  }
  void redo() {
    if (canRedo()) ++at_;
  }

 private:
  std::vector<Level> steps_;
  std::size_t at_ = 0;
  std::optional<Level> change_;
};

TEST(Session, HistoryIsAListOfLevelsAndAPlaceInIt) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Session session;
    session.open(levels / "2-cylinder.json");
    const Level opened = session.level();
    Model model(opened);
    for (int i = 0; i < 80; ++i) {
      const Level next = random.integer(0, 5) == 0 ? session.level() : numbered(random.integer(0, 3));
      switch (random.integer(0, 7)) {
        case 0:
        case 1:
          session.change(next);
          model.change(next);
          break;
        case 2:
          session.finishChange();
          model.finish();
          break;
        case 3:
          session.cancelChange();
          model.cancel();
          break;
        case 4:
          session.undo();
          model.undo();
          break;
        case 5:
          session.redo();
          model.redo();
          break;
        case 6:
          session.edit(next);
          model.finish();
          model.change(next);
          model.finish();
          break;
        default:
          if (random.integer(0, 3) > 0) break;
          session.reset();
          model.finish();
          model.change(opened);
          model.finish();
      }
      ASSERT_EQ(session.level(), model.level()) << "step " << i;
      ASSERT_EQ(session.changing(), model.changing()) << "step " << i;
      ASSERT_EQ(session.canUndo(), model.canUndo()) << "step " << i;
      ASSERT_EQ(session.canRedo(), model.canRedo()) << "step " << i;
      ASSERT_EQ(session.modified(), !(model.level() == opened)) << "step " << i;
    }
  }
}

TEST(Session, DragIsOneStep) {
  Session session;
  for (int i = 1; i <= 100; ++i) session.change(numbered(i));
  EXPECT_EQ(session.level(), numbered(100));
  session.finishChange();
  session.undo();
  EXPECT_EQ(session.level(), Level());
  EXPECT_FALSE(session.canUndo());
  session.redo();
  EXPECT_EQ(session.level(), numbered(100));
}

TEST(Session, WhatEndsAsItBeganIsNoStepAndKeepsWhatCanBeRedone) {
  Session session;
  session.edit(numbered(1));
  session.undo();
  session.change(numbered(2));
  session.change(Level());
  session.finishChange();
  session.edit(Level());
  session.change(numbered(3));
  session.cancelChange();
  EXPECT_FALSE(session.canUndo());
  ASSERT_TRUE(session.canRedo());
  session.redo();
  EXPECT_EQ(session.level(), numbered(1));
}

TEST(Session, NewEditClearsWhatCouldBeRedone) {
  Session session;
  session.edit(numbered(1));
  session.undo();
  session.edit(numbered(2));
  EXPECT_FALSE(session.canRedo());
  session.redo();
  EXPECT_EQ(session.level(), numbered(2));
}

TEST(Session, HistoryIsLongButNotEndless) {
  Session session;
  for (int i = 1; i <= 1200; ++i) session.edit(numbered(i));
  int steps = 0;
  for (; session.canUndo(); session.undo()) ++steps;
  EXPECT_EQ(steps, 1000);
  EXPECT_EQ(session.level(), numbered(200));
  for (; session.canRedo(); session.redo()) --steps;
  EXPECT_EQ(steps, 0);
  EXPECT_EQ(session.level(), numbered(1200));
}

TEST(Session, ResetCanBeUndone) {
  Session session;
  session.open(levels / "1-plane.json");
  const Level opened = session.level();
  session.edit(numbered(1));
  EXPECT_TRUE(session.modified());
  session.reset();
  EXPECT_EQ(session.level(), opened);
  EXPECT_FALSE(session.modified());
  session.undo();
  EXPECT_EQ(session.level(), numbered(1));
}

TEST(Session, OpeningForgetsTheHistoryAndIsNoticed) {
  Session session;
  EXPECT_EQ(session.generation(), 0);
  session.open(levels / "1-plane.json");
  const int generation = session.generation();
  session.edit(numbered(1));
  session.undo();
  session.change(numbered(2));
  session.open(levels / "3-sphere.json");
  EXPECT_GT(session.generation(), generation);
  EXPECT_FALSE(session.canUndo() || session.canRedo() || session.changing() || session.modified());
  EXPECT_EQ(session.path(), levels / "3-sphere.json");
  EXPECT_TRUE(session.level().optic.shape().as<SphereMirror>() != nullptr);
}

TEST(Session, FailingToOpenLeavesEverything) {
  Session session;
  session.open(levels / "1-plane.json");
  session.edit(numbered(1));
  session.edit(numbered(2));
  session.undo();
  session.change(numbered(3));
  const int generation = session.generation();
  for (const std::filesystem::path& bad :
       {levels / "nothing.json", std::filesystem::path(), levels, levels / "../README.md"}) {
    EXPECT_THROW(session.open(bad), Error) << bad;
    EXPECT_EQ(session.path(), levels / "1-plane.json");
    EXPECT_EQ(session.generation(), generation);
    EXPECT_TRUE(session.changing());
    EXPECT_EQ(session.level(), numbered(3));
  }
  session.cancelChange();
  session.redo();
  EXPECT_EQ(session.level(), numbered(2));
}

TEST(Session, ThesisScenesOpenWithABoxInView) {
  int opened = 0;
  for (const auto& entry : std::filesystem::directory_iterator(scenes)) {
    SCOPED_TRACE(entry.path());
    Session session;
    session.open(entry.path());
    ++opened;
    EXPECT_EQ(session.level().original.shape, OriginalShape(BoxShape{}));
    EXPECT_EQ(session.level().camera.target, session.level().original.placement.position);
    EXPECT_FALSE(session.modified());
  }
  EXPECT_GE(opened, 5);
}

}  // namespace
}  // namespace anamorph
