// What tests with a real window share.
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "cannot_run_here.h"
#include "virtual_window.h"

namespace anamorph::testing {

class WindowTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* program : {"Xvfb", "xdotool"}) {
      if (!isInstalled(program)) return cannotRunHere(std::string(program) + " is not installed");
    }
  }
  void TearDown() override {
    if (window && HasFailure()) ADD_FAILURE() << "stderr: " << window->errorText();
    window.reset();  // before the folders it writes into
  }

  std::unique_ptr<VirtualWindow> window;
};

}  // namespace anamorph::testing
