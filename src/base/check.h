// CHECK(condition): programming errors, on in release too: a crash found early is worth more than a wrong
// sculpture. What users and files can cause is an Error instead (error.h).
#pragma once

#include <stdexcept>
#include <string>

namespace anamorph {

/// Thrown by CHECK; main turns it into exit code 3.
struct ProgrammingError : std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] inline void failCheck(const char* condition, const char* file, int line) {
  throw ProgrammingError(std::string(file) + ":" + std::to_string(line) + ": CHECK(" + condition +
                         ") failed");
}

}  // namespace anamorph

#define CHECK(condition) \
  ((condition) ? static_cast<void>(0) : ::anamorph::failCheck(#condition, __FILE__, __LINE__))
