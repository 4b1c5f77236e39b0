// How long the frames of an action take, all of them: a benchmark acts as a person does and draws frames as the
// window does, without forced quality, until nothing is unfinished.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "app/headless_gui.h"

namespace anamorph {

/// Milliseconds, with all that OpenGL was asked for.
struct ActionFrames {
  std::string action;
  std::size_t frames = 0;
  double longest = 0;
};

class FrameRecorder {
 public:
  explicit FrameRecorder(HeadlessGui& headless) : headless_(headless) {}

  /// The frames from here on belong to this action.
  void begin(std::string action);
  /// One frame. What `act` does happens between two frames and delays the second, as an event of a window does.
  void frame(const std::function<void()>& act = {});
  /// Frames as long as `unfinished` says so, at most one in a sixtieth of a second.
  void framesWhile(const std::function<bool()>& unfinished);
  /// Frames until the window would rest.
  void rest();

  const std::vector<ActionFrames>& actions() const { return actions_; }

 private:
  using Clock = std::chrono::steady_clock;

  HeadlessGui& headless_;
  Clock::time_point last_ = Clock::now();
  std::vector<ActionFrames> actions_;
};

}  // namespace anamorph
