// What the level itself says to a condition of a lesson's step. The step that runs (edit/lesson_run.h) asks the level as it
// is, the check of a lesson (lesson_check.h) the level that a move would make.
#pragma once

#include <optional>

#include "level/lesson.h"
#include "level/level.h"

namespace anamorph {

/// Of a level that was `begin` when the step began; nothing for a condition that is not about the level.
std::optional<bool> holdsOfLevel(const StepCondition& condition, const LevelScene& begin,
                                 const LevelScene& level);

}  // namespace anamorph
