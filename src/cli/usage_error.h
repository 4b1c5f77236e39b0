// A command line that makes no sense, found after its parts were understood one by one; exit code 2.
#pragma once

#include <stdexcept>

namespace anamorph {

struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace anamorph
