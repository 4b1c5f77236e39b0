// Which step of which lesson something belongs to, so that it ends when another one opens.
#pragma once

#include <cstddef>

#include "edit/lesson_run.h"

namespace anamorph {

/// A step of a level that was opened: the session's generation, and its number.
struct StepOfLesson {
  int generation = 0;
  std::size_t step = 0;

  bool operator==(const StepOfLesson&) const = default;
};

inline StepOfLesson openStepOf(const LessonRun& run) {
  return {run.generation, run.step};
}

}  // namespace anamorph
