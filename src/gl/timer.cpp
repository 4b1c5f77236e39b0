#include "gl/timer.h"

#include <algorithm>

#include <glad/gl.h>

namespace anamorph {

GpuTimer::GpuTimer() {
  glGenQueries(1, &query_);
}

GpuTimer::~GpuTimer() {
  if (state_ == State::measuring) end();
  glDeleteQueries(1, &query_);
}

void GpuTimer::begin() {
  result();
  if (state_ != State::idle) return;
  glBeginQuery(GL_TIME_ELAPSED, query_);
  begun_ = Clock::now();
  state_ = State::measuring;
}

void GpuTimer::end() {
  if (state_ != State::measuring) return;
  glEndQuery(GL_TIME_ELAPSED);
  state_ = State::waiting;
}

double GpuTimer::result() {
  if (state_ == State::waiting) {
    GLuint arrived = 0;
    glGetQueryObjectuiv(query_, GL_QUERY_RESULT_AVAILABLE, &arrived);
    if (arrived) read();
  }
  return milliseconds_;
}

double GpuTimer::waitForResult() {
  if (state_ == State::waiting) read();
  return milliseconds_;
}

void GpuTimer::read() {
  GLuint64 nanoseconds = 0;
  glGetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
  // Mesa's software renderer sometimes counts from the start of the machine.
  const std::chrono::duration<double, std::milli> most = Clock::now() - begun_;
  milliseconds_ = std::min(static_cast<double>(nanoseconds) * 1e-6, most.count());
  state_ = State::idle;
}

}  // namespace anamorph
