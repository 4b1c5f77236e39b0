// The Dutch table of texts, for the tests that look whether it is complete.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "level/json.h"
#include "source_text.h"

namespace anamorph::testing {

/// The English texts that the Dutch table has.
inline std::vector<std::string> dutchKeys() {
  const JsonValue json = parseJson(textOf(sourceFolder / "assets/languages/nl.json"), "nl.json");
  const auto texts = std::find(json.keys.begin(), json.keys.end(), "texts") - json.keys.begin();
  return json.items.at(static_cast<std::size_t>(texts)).keys;
}

inline bool isSmall(char c) {
  return c >= 'a' && c <= 'z';
}

/// Whether there are two small letters side by side.
inline bool hasWord(const std::string& text) {
  const auto both = [](char a, char b) { return isSmall(a) && isSmall(b); };
  return std::adjacent_find(text.begin(), text.end(), both) != text.end();
}

}  // namespace anamorph::testing
