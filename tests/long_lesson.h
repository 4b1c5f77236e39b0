// A lesson as long as a level may have one.
#pragma once

#include <string>

namespace anamorph::testing {

/// JSON of nearly 1 MiB: as many steps as there is room for, each nearly as long as a text may be.
inline std::string longLesson() {
  std::string steps;
  for (int i = 0; i < 16; ++i) {
    steps += (i == 0 ? "" : ", ") + std::string(R"({"id": "s)") + std::to_string(i) +
             R"(", "title": "A", "why": ")" + std::string(64'000, 'x') + R"(", "do": ""})";
  }
  return R"({"id": "long", "steps": [)" + steps + "]}";
}

}  // namespace anamorph::testing
