// The words of a lesson's step, in the panel and large for an audience; and what its help points at and does.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Why, the figure, what is asked, what to do once that is answered, and what to notice once it is done; in the current
/// font, wrapped. Without what to do when `withTask` is false.
void drawStepText(Editor& editor, UiState& ui, bool withTask);
/// What to do, beside a bar; and how high that is at a width, in pixels.
void drawTask(const LessonRun& run, UiState& ui);
float taskHeight(const LessonRun& run, const Look& look, float width);

/// The answers of the open step's question, to be chosen, wrapped; and how high they are at a width, in pixels, in the current
/// font.
void drawAnswers(Editor& editor, UiState& ui);
float answersHeight(const LessonRun& run, float width);

/// A dot for every step: filled when done, ringed when open, small when optional. A click opens a step.
void drawStepDots(Editor& editor, const Look& look);

/// "Step 2 of 6"
std::string stepCount(const LessonRun& run);

/// "Where?": opens the tab of the open step, brings its control into sight and outlines it. Nothing is done.
void pointAtStep(Editor& editor, UiState& ui);
bool canPointAt(const LessonRun& run);

/// "Do it": the same, and begins the step's move.
void doStep(Editor& editor, UiState& ui);
bool canPlay(const LessonRun& run);

}  // namespace anamorph
