// System calls that a signal interrupts are made again.
#pragma once

#include <cerrno>

namespace anamorph {

/// What `call` returns once it does not fail with EINTR.
template <typename Call>
auto retried(const Call& call) {
  while (true) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

}  // namespace anamorph
