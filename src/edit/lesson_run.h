// A lesson being worked through: which step is open, what of its conditions has been observed, and the move
// that "show me" makes. Nothing reports to the lesson: every frame it looks at the editor and compares it
// with what was there when the step was opened.
//
//   openStep()  ---------------- frames ---------------->  done
//   facts then      facts now: holds(condition, then, now)?
#pragma once

#include <cstddef>
#include <optional>

#include "edit/editor.h"
#include "edit/lesson_state.h"
#include "level/lesson.h"

namespace anamorph {

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

/// Begins the open step's move, which takes a second or two; nothing when it has none. The level's part of it
/// is one step of the history.
void playStep(Editor& editor);
/// The move to its end at once.
void finishPlay(Editor& editor);

/// Goes on by `seconds`; for advance().
bool advancePlay(Editor& editor, double seconds);

}  // namespace anamorph
