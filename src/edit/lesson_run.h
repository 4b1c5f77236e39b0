// A lesson being worked through: which step is open, what of its conditions has been observed, and the move
// that "show me" makes. Nothing reports to the lesson: every frame it looks at the editor and compares it
// with what was there when the step was opened.
//
//   openStep()  ---------------- frames ---------------->  done
//   facts then      facts now: holds(condition, then, now)?
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "edit/pick.h"
#include "edit/view_pose.h"
#include "level/lesson.h"
#include "level/level.h"

namespace anamorph {

struct Editor;

/// What the conditions look at.
struct LessonFacts {
  Level level;
  ViewPose pose;
  std::optional<PickedPoint> point;
  std::optional<GridCell> cell;
  int undone = 0, exported = 0;  ///< how often
};

/// The steps that have been done, by the lessons' ids; kept between runs of the program.
using LessonProgress = std::map<std::string, std::set<std::string>>;

/// A move that goes on.
struct StepPlay {
  StepMove move;
  Level from, last;  ///< before it, and as it left it in the last frame
  double morphFrom = 1;
  double seconds = 0;
  static constexpr double duration = 1.4;
};

struct LessonRun {
  Lesson lesson;
  std::size_t step = 0;  ///< that is open
  bool done = false;     ///< the open step, now or at some time before
  bool doneNow = false;  ///< since it was opened
  LessonFacts begin;     ///< when it was opened
  /// Of the step's conditions: each has to become true while the step is open, so one that already holds
  /// has to be seen false first.
  std::vector<bool> wasFalse, seen;
  int generation = 0;            ///< of the session that the lesson is of
  std::string text;              ///< of the lesson in the level, which may be pasted or undone
  std::optional<StepPlay> play;  ///< "show me" at work

  bool empty() const { return lesson.steps.empty(); }
  const LessonStep& open() const { return lesson.steps[step]; }
};

/// Whether a condition holds now; nothing while that is not known, because the match is being measured.
std::optional<bool> holds(const StepCondition& condition, const LessonFacts& begin, const Editor& editor);

/// Takes up the lesson of another level when one was opened, and looks at the open step's conditions. Returns
/// whether something that is shown changed.
bool advanceLesson(Editor& editor);

/// Opens a step; further than the last is the last.
void openStep(Editor& editor, std::size_t step);
/// To the next step; one that is only read is done by it.
void nextStep(Editor& editor);
void previousStep(Editor& editor);

/// A lesson in figures. Every step that is not optional gives 10 points, optional ones 5.
struct LessonScore {
  std::size_t done = 0, steps = 0;
  int points = 0, of = 0;
  bool badge = false;  ///< all steps that are not optional are done
};
LessonScore scoreOf(const Lesson& lesson, const LessonProgress& progress);
bool isDone(const Lesson& lesson, const LessonStep& step, const LessonProgress& progress);

/// Begins the open step's move, which takes a second or two; nothing when it has none. The level's part of it
/// is one step of the history.
void playStep(Editor& editor);
/// The move to its end at once.
void finishPlay(Editor& editor);

/// Goes on by `seconds`; for advance().
bool advancePlay(Editor& editor, double seconds);

}  // namespace anamorph
