// What the window does, for those who watch it from outside (tests, demonstrations): one JSON line for every
// frame that it draws. While nothing is drawn, nothing is written; so the lines also tell that it rests.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/gui.h"

namespace anamorph {

/// One line of the log: number of the frame, level, what can be edited, selection, history, match, view,
/// places of the panels in pixels.
std::string stateLine(Gui& gui, std::size_t frame);

class StateLog {
 public:
  /// Begins an empty file. An empty path: no log. Throws Error.
  explicit StateLog(const std::filesystem::path& path);
  /// After a frame.
  void add(Gui& gui);

 private:
  std::ofstream file_;
  std::size_t frames_ = 0;
};

}  // namespace anamorph
