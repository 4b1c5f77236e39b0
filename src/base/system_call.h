// Calls of the system: those that a signal interrupts are made again, those that fail say why.
#pragma once

#include <cerrno>
#include <cstring>
#include <string>

namespace anamorph {

/// What `call` returns once it does not fail with EINTR.
template <typename Call>
auto retried(const Call& call) {
  while (true) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

/// Why the last call failed: "No space left on device".
inline std::string systemReason() {
  return std::strerror(errno);
}

}  // namespace anamorph
