// The OpenGL context that the tests of a program share. Machines without EGL cannot run them.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "cannot_run_here.h"
#include "gl/gl_error.h"
#include "gl/offscreen_context.h"

namespace anamorph::test {

/// Null, and `problem` says why, when there is none.
inline OffscreenContext* sharedContext(std::string& problem) {
  static std::string why;
  static const std::unique_ptr<OffscreenContext> context = [] {
    try {
      return std::make_unique<OffscreenContext>();
    } catch (const Error& error) {
      why = error.what();
      return std::unique_ptr<OffscreenContext>();
    }
  }();
  problem = why;
  return context.get();
}

/// Makes the context current; a test fails when it leaves an OpenGL error behind.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string problem;
    OffscreenContext* const context = sharedContext(problem);
    if (!context) return cannotRunHere(problem);
    context->makeCurrent();
    takeGlErrors();
    ready_ = true;
  }
  void TearDown() override {
    if (ready_) {
      EXPECT_EQ(takeGlErrors(), "");
    }
  }

 private:
  bool ready_ = false;
};

}  // namespace anamorph::test
