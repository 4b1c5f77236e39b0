#include "app/frame_recorder.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <glad/gl.h>

namespace anamorph {

void FrameRecorder::begin(std::string action) {
  actions_.push_back({std::move(action)});
}

void FrameRecorder::frame(const std::function<void()>& act) {
  const auto start = Clock::now();
  if (act) act();
  const double passed = std::chrono::duration<double>(start - std::exchange(last_, start)).count();
  headless_.frame(std::clamp(passed, 1e-4, 0.1));
  glFinish();
  ActionFrames& now = actions_.back();
  ++now.frames;
  now.longest =
      std::max(now.longest, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
}

void FrameRecorder::framesWhile(const std::function<bool()>& unfinished) {
  constexpr auto refresh = std::chrono::microseconds(16667);
  do {
    frame();
    std::this_thread::sleep_until(last_ + refresh);
  } while (unfinished());
}

void FrameRecorder::rest() {
  framesWhile([&] { return headless_.gui().unfinished(); });
}

}  // namespace anamorph
