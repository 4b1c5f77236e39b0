// What a move of a lesson's step makes of the numbers and switches of a level and of its kind of mirror: the part of it
// that needs no window, so that `anamorph check` can foretell what the window will do.
#pragma once

#include "level/lesson.h"
#include "level/level.h"

namespace anamorph {

/// Switches that can only be one or the other: the kind of mirror, refinement, how finely a box is divided, formulas put
/// right.
void setSwitches(LevelScene& level, const StepMove& move);
/// Numbers of eye, original and sculpture, `part` of the way to those of the move, 0..1.
void setNumbers(LevelScene& level, const StepMove& move, double part);

}  // namespace anamorph
