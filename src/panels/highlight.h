// The control that a lesson's step points at: outlined for some seconds, and scrolled to once. Controls find it through
// Dear ImGui's context, so that a row needs no more than its name:
//
//   { const HighlightScope scope(ui.highlight);   ... rows call highlightItem("Depth scale k") ... }
#pragma once

#include <string>

#include <imgui.h>

#include "panels/step_of_lesson.h"

namespace anamorph {

struct Highlight {
  std::string control;    ///< its English name; empty: none
  double seconds = 0;     ///< that are left
  StepOfLesson step;      ///< that asked for it: it ends with it
  bool moving = false;    ///< it ends with the move of "Do it", too
  bool scrolled = false;  ///< it has been brought into view
  int frames = 0;         ///< since it is pointed at
  int outlined = 0;       ///< how often a control has been, for tests
};

/// Begins to point at a control of the open step, for some seconds; "": at none.
void startHighlight(Highlight& highlight, const std::string& control, const LessonRun& run);
/// Goes on by `seconds`; ends with its time, with the move that it belongs to, and when another step opens.
void advanceHighlight(Highlight& highlight, const LessonRun& run, double seconds);

/// Lets the controls that are drawn while it lives find the highlight.
class HighlightScope {
 public:
  explicit HighlightScope(Highlight& highlight);
  ~HighlightScope();
  HighlightScope(const HighlightScope&) = delete;
  HighlightScope& operator=(const HighlightScope&) = delete;

 private:
  void* before_;
};

/// Whether a control is pointed at that was not drawn in the last frames: it may be in something that is folded.
bool isHighlightMissing();

/// Outlines this part of the window when the control of that name is pointed at.
void highlightArea(const char* control, const ImVec2& low, const ImVec2& high);
/// The same of the control that was drawn last.
void highlightItem(const char* control);

}  // namespace anamorph
