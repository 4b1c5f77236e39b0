// How everything in the window is drawn: what widgets, figures and dialogs have to know of it. Plain data.
#pragma once

struct ImFont;

namespace anamorph {

/// The fonts that the window has loaded; null: Dear ImGui's own.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* strong = nullptr;
  ImFont* title = nullptr;
  ImFont* huge = nullptr;  ///< for an audience; loaded while presenting
};

enum class Theme { dark, light, projector };

/// As it is in force; the preferences say how it is to be (panels/preferences.h).
struct Look {
  Theme theme = Theme::dark;
  double scale = 1;  ///< of everything, from the preferences or the screen
  Fonts fonts;
};

}  // namespace anamorph
