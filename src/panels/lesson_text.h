// The words of a lesson's step, in the panel and large for an audience; and what "show me" points at.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// Why, the figure, what to do, and what to notice once it is done; in the current font, wrapped.
void drawStepText(const LessonRun& run, LongTexts& texts, const Look& look);

/// A dot for every step: filled when done, ringed when open, small when optional. A click opens a step.
void drawStepDots(Editor& editor, const Look& look);

/// "Step 2 of 6"
std::string stepCount(const LessonRun& run);

/// Opens the tab, outlines the control and begins the move of the open step.
void showStep(Editor& editor, UiState& ui);

/// Whether the open step has something to show.
bool canShow(const LessonRun& run);

}  // namespace anamorph
