// The window of the system: GLFW, its events, and the loop that draws when there is something to draw and
// sleeps otherwise.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "edit/session.h"
#include "panels/look.h"

namespace anamorph {

struct WindowOptions {
  LevelFile level;
  std::filesystem::path model;  ///< a mesh that takes the original's place; empty: none
  std::optional<Theme> theme;
  std::string language;  ///< empty: as in the preferences
  std::optional<double> uiScale;
  bool fullscreen = false;
  int width = 1280, height = 800;
  std::size_t step = 0;            ///< of the lesson that is opened, from 1 on; 0: where the student left off
  bool present = false;            ///< in large letters for an audience
  bool tour = true;                ///< show newcomers around
  std::filesystem::path stateLog;  ///< state_log.h; empty: none
};

/// Opens the window and returns when it is closed. Throws Error when there is no display or no OpenGL 3.3.
void runWindow(const WindowOptions& options);

}  // namespace anamorph
