// Words for messages.
#pragma once

#include <string>
#include <vector>

namespace anamorph {

/// "a, b or c"
std::string alternatives(const std::vector<std::string>& texts);

/// The text, and what else there is to say of it: "text; a; b"
std::string withRemarks(std::string text, const std::vector<std::string>& remarks);

}  // namespace anamorph
