// How many of something there are, in words: "1 triangle", "12 triangles".
#pragma once

#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "base/language.h"

namespace anamorph {

/// The number and what it counts, in the chosen language; `one` and `many` are the English words.
inline std::string countOf(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, tr(count == 1 ? one : many));
}

}  // namespace anamorph
