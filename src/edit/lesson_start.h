// What a step of a lesson begins with: the level as it is in its file, changed by the step's own `start`, so that it
// is the same whichever way a step is reached.
//
//   the level's file  --start of step 3-->  the level of step 3, opened from anywhere but step 2
//
// Who goes on from the step before keeps what he has made; only where that is far from what the step needs, it is
// offered to him.
#pragma once

#include <cstddef>

#include "edit/editor.h"

namespace anamorph {

/// The level that a step begins with. The words are those of the session's level.
Level startOf(const Editor& editor, std::size_t step);

/// The level and the view become what the open step begins with; the level's part is one step of the history.
void restoreStart(Editor& editor);
/// The same for a level that has just been opened: it begins so, and nobody has changed it.
void beginAtStart(Editor& editor);

/// Whether a level is far from what the open step's start asks for: a switch is another one, or a number is more than a
/// fifth off.
bool isStartMissed(const LessonRun& run, const Level& level);

}  // namespace anamorph
