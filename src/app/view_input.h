// From the editor to what the 3D view draws: a value, made anew every frame and compared.
#pragma once

#include "edit/editor.h"
#include "panels/ui_state.h"
#include "viewport/viewport.h"

namespace anamorph {

class ViewInputMaker {
 public:
  ViewportInput make(Editor& editor, const UiState& ui, bool transparent);

  /// Seconds that the rays' animation takes from start to end; 0 when nothing is animated.
  static double animationSeconds(const Editor& editor);
  /// Takes the step that work.rayStep asks for: pauses the animation where the next or the last piece ends.
  static void stepRays(Editor& editor);

 private:
  std::shared_ptr<const std::vector<Line>> lines_;  // the last ones: the same lines keep their pointer
};

/// All lines of the view: rays, RT camera, construction.
std::vector<Line> makeLines(const Editor& editor, const UiState& ui);

}  // namespace anamorph
