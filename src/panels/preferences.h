// What the user has chosen for all levels; kept between runs (app/preferences.h).
#pragma once

#include <string>

#include "panels/look.h"

namespace anamorph {

struct Preferences {
  Theme theme = Theme::dark;
  double uiScale = 0;    ///< 0: as the screen says; else 0.75..3
  bool vrtKeys = false;  ///< T/R/S for move, rotate, scale as in Virtual Ray Tracer, instead of W/E/R
  bool legend = true;
  bool tourSeen = false;
  double leftWidth = 264, rightWidth = 336, previewHeight = 416;  ///< at 100 % UI scale
  std::string language;                                           ///< code; empty: as the system is set

  bool operator==(const Preferences&) const = default;
};

}  // namespace anamorph
