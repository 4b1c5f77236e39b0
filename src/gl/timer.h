// How long the graphics processor works: GL_TIME_ELAPSED around a piece of drawing. The answer comes frames
// later; result() never waits for it.
#pragma once

#include <chrono>
#include <cstdint>

namespace anamorph {

class GpuTimer {
 public:
  GpuTimer();
  ~GpuTimer();
  GpuTimer(const GpuTimer&) = delete;
  GpuTimer& operator=(const GpuTimer&) = delete;

  /// Around what is measured; not nested. While an earlier answer is still to come, begin() measures nothing.
  void begin();
  void end();

  /// Milliseconds of the last measurement that has arrived; 0 before the first.
  double result();
  /// Waits for the one under way.
  double waitForResult();

 private:
  using Clock = std::chrono::steady_clock;
  enum class State { idle, measuring, waiting };

  void read();

  std::uint32_t query_ = 0;
  State state_ = State::idle;
  double milliseconds_ = 0;
  Clock::time_point begun_{};
};

}  // namespace anamorph
