// The words of a lesson's step, in the panel and large for an audience; and what "show me" points at.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

/// In the chosen language, wrapped, with numbers that stay with their percent sign.
void wrappedText(const std::string& english);

/// Why, the figure, what to do, and what to notice once it is done; in the current font, wrapped.
void drawStepText(const LessonRun& run, const UiState& ui);

/// A dot for every step: filled when done, ringed when open, small when optional. A click opens a step.
void drawStepDots(Editor& editor, const UiState& ui);

/// "Step 2 of 6"
std::string stepCount(const LessonRun& run);

/// Opens the tab, outlines the control and begins the move of the open step.
void showStep(Editor& editor, UiState& ui);

/// Whether the open step has something to show.
bool canShow(const LessonRun& run);

/// Nothing, or the open step's control while it is pointed at; to be called once a frame.
void updateHighlight(const Editor& editor, UiState& ui, double seconds);

}  // namespace anamorph
