// Words for messages.
#pragma once

#include <string>
#include <vector>

namespace anamorph {

/// "a, b or c"; `word`: the "or" of the language.
std::string alternatives(const std::vector<std::string>& texts, const std::string& word = "or");

}  // namespace anamorph
