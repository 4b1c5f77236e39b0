// The moves of a lesson's steps (StepMove): what they make of a level and of the view. "Do it" makes one before the
// student's eyes (lesson_play.cpp), the start of a step makes one at once (lesson_start.h).
#pragma once

#include "edit/editor.h"
#include "level/lesson.h"

namespace anamorph {

/// From 0 to 1 as t does, slow at both ends.
double eased(double t);
/// What cannot be half done, done. `box` is that of the placed original, whose place another shape takes.
Level begun(const StepMove& move, Level level, const Box& box);
/// A level that was begun, so far into the rest of the move, 0..1.
Level levelAt(const StepMove& move, const Level& begun, double fraction);
/// The part of a move that is not the level's: where the view is flown to, what is picked and shown.
void moveView(Editor& editor, const StepMove& move);

}  // namespace anamorph
