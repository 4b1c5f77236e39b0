// What is kept of a lesson that is being worked through, and of those done before: plain data, and the points that
// follow from it. What happens to it is in lesson_run.h.
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

/// What the conditions look at.
struct LessonFacts {
  Level level;
  ViewPose pose;  ///< at the end of a flight that goes on
  std::optional<PickedPoint> point;
  std::optional<GridCell> cell;
  double wipe = 0.5;
  int undone = 0, exported = 0;  ///< how often
};

/// The steps that have been done, by the lessons' ids; kept between runs of the program.
using LessonProgress = std::map<std::string, std::set<std::string>>;

/// A move that goes on.
struct StepPlay {
  StepMove move;
  Level from, last;  ///< before it, and as it left it in the last frame
  double morphFrom = 1, wipeFrom = 0.5;
  double seconds = 0;
  static constexpr double duration = 1.4;
};

struct LessonRun {
  Lesson lesson;
  std::size_t step = 0;  ///< that is open
  bool done = false;     ///< the open step, now or at some time before
  bool doneNow = false;  ///< since it was opened
  LessonFacts begin;     ///< when it was opened
  /// Of the step's conditions: each has to become true while the step is open, so one that already holds has to be
  /// seen false first; but not a state that the student brought along from the step before.
  std::vector<bool> wasFalse, seen;
  std::optional<std::size_t> answer;  ///< that was given last to the step's question
  Level base;                    ///< that the steps' starts are made of: as it is in its file, or was pasted
  int generation = 0;            ///< of the session that the lesson is of
  std::string text;              ///< of the lesson in the level, which may be pasted or undone
  std::optional<StepPlay> play;  ///< "do it" at work

  bool empty() const { return lesson.steps.empty(); }
  const LessonStep& open() const { return lesson.steps[step]; }
};

/// A lesson in figures. Every step that is not optional gives 10 points, optional ones 5.
struct LessonScore {
  std::size_t done = 0, steps = 0;
  int points = 0, of = 0;
  bool badge = false;  ///< all steps that are not optional are done
};
LessonScore scoreOf(const Lesson& lesson, const LessonProgress& progress);
/// Whether a step is done by reading it: it waits for nothing and asks nothing.
bool isOnlyRead(const LessonStep& step);
/// Whether there is nothing to answer in the open step, or it was answered right.
bool isAnswered(const LessonRun& run);
bool isDone(const Lesson& lesson, const LessonStep& step, const LessonProgress& progress);

}  // namespace anamorph
