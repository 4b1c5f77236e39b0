// A lesson being worked through: which step is open, what of its conditions has been observed, and the move
// that "do it" makes. Nothing reports to the lesson: every frame it looks at the editor and compares it
// with what was there when the step was opened.
//
//   openStep()  ---------------- frames ---------------->  done
//   facts then      facts now: holds(condition, then, now)?
//
// Going on keeps the level as the student has made it; every other way to a step makes it what the step begins with
// (lesson_start.h).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "edit/editor.h"
#include "edit/lesson_state.h"
#include "level/lesson.h"

namespace anamorph {

/// Whether a condition holds now; nothing while that is not known, because a drag goes on or the match is being measured.
std::optional<bool> holds(const StepCondition& condition, const LessonFacts& begin, const Editor& editor);

/// Takes up the lesson of another level when one was opened, and looks at the open step's conditions. Returns
/// whether something that is shown changed.
bool advanceLesson(Editor& editor);

/// Opens a step, with the level and the view that it begins with; further than the last is the last. What the level
/// was is one step back in the history.
void openStep(Editor& editor, std::size_t step);
/// To the next step, with the level as it is; a step that is only read is done by it.
void nextStep(Editor& editor);
void previousStep(Editor& editor);
/// Answers the open step's question; another number than one of its answers does nothing.
void answerStep(Editor& editor, std::size_t answer);

/// Answers the open step's question and begins its move, which takes a second or two; nothing when it has none. The
/// level's part of it is one step of the history. A move that another original than the step's own cannot make is said
/// to be so instead.
void playStep(Editor& editor);
/// The points of the original that the open step's move picks; none where another original has taken its place.
std::vector<Point> pointsOfMove(const Editor& editor);
/// The move to its end at once.
void finishPlay(Editor& editor);

/// Goes on by `seconds`; for advance().
bool advancePlay(Editor& editor, double seconds);

}  // namespace anamorph
