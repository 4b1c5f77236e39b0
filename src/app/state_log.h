// What the window does, for those who watch it from outside (tests, demonstrations): one JSON line for every
// frame that it draws, and one when it comes to rest. A line tells how much input its frame has seen, so that whoever sends
// some knows when it has arrived, however busy the machine is.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/gui.h"

namespace anamorph {

/// How much input the window has received since it was opened.
struct InputCounts {
  std::size_t keysDown = 0;  ///< repetitions of a key that is held do not count
  std::size_t keysUp = 0;    ///< that Dear ImGui was told of
  std::size_t characters = 0;
  std::size_t buttonsDown = 0, buttonsUp = 0, wheel = 0;
  std::size_t motions = 0;
};

/// One line of the log: number of the frame, level, what can be edited, selection, history, match, view,
/// places of the panels in pixels, the input that the frame has seen; whether the window draws nothing more until
/// something happens.
std::string stateLine(Gui& gui, std::size_t frame, const InputCounts& seen = {}, bool resting = false);

class StateLog {
 public:
  /// Begins an empty file. An empty path: no log. Throws Error.
  explicit StateLog(const std::filesystem::path& path);
  /// After a frame that has seen so much input.
  void add(Gui& gui, const InputCounts& seen);
  /// Before the window waits until something happens.
  void addRest(Gui& gui);

 private:
  std::ofstream file_;
  InputCounts seen_;  // by the last frame
  std::size_t frames_ = 0;
};

}  // namespace anamorph
