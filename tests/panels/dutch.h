// The Dutch table of texts, for the tests that look whether it is complete.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "level/json.h"
#include "source_text.h"

namespace anamorph::testing {

/// The English texts of the Dutch table with the Dutch ones.
inline std::vector<std::pair<std::string, std::string>> dutchTexts() {
  const JsonValue json = parseJson(textOf(sourceFolder / "assets/languages/nl.json"), "nl.json");
  const auto at = std::find(json.keys.begin(), json.keys.end(), "texts") - json.keys.begin();
  const JsonValue& table = json.items.at(static_cast<std::size_t>(at));
  std::vector<std::pair<std::string, std::string>> texts;
  for (std::size_t i = 0; i < table.keys.size(); ++i) texts.emplace_back(table.keys[i], table.items[i].text);
  return texts;
}

/// The English texts that the Dutch table has.
inline std::vector<std::string> dutchKeys() {
  std::vector<std::string> keys;
  for (const auto& [english, dutch] : dutchTexts()) keys.push_back(english);
  return keys;
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
