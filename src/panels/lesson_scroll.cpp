#include "panels/lesson_scroll.h"

#include <imgui.h>

namespace anamorph {

void scrollToStep(LessonScroll& scroll, const LessonRun& run) {
  constexpr int layoutFrames = 3;  // until the height of what has been added is known
  if (scroll.step != openStepOf(run)) {
    ImGui::SetScrollY(0);
    scroll.framesToNotice = 0;
  } else if (run.done && !scroll.done) {
    scroll.framesToNotice = layoutFrames;
  }
  scroll.step = openStepOf(run);
  scroll.done = run.done;
}

void scrollToNotice(LessonScroll& scroll) {
  if (scroll.framesToNotice == 0) return;
  ImGui::SetScrollHereY(1);
  --scroll.framesToNotice;
}

}  // namespace anamorph
