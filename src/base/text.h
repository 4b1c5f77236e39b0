// Words for messages.
#pragma once

#include <string>
#include <vector>

namespace anamorph {

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& texts);

}  // namespace anamorph
