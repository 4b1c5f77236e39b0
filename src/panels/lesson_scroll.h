// Where the lesson's text is scrolled to: to its top when another step opens, down to what there is to notice when the
// open step has just been done.
#pragma once

#include "panels/step_of_lesson.h"

namespace anamorph {

struct LessonScroll {
  StepOfLesson step;        ///< as it was drawn last, and
  bool done = false;        ///< whether it was done then
  int framesToNotice = 0;   ///< for which the end of the text is still to be brought into view
  bool taskPinned = false;  ///< not all of the text fits: what to do stands below it and does not scroll
};

/// To be called inside the window that scrolls, before its text is drawn.
void scrollToStep(LessonScroll& scroll, const LessonRun& run);
/// The same, after it.
void scrollToNotice(LessonScroll& scroll);

}  // namespace anamorph
