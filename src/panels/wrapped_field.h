// A field of several lines of text. Dear ImGui's own does not wrap: so what is not being typed is shown wrapped, and a
// click, or Enter, begins typing.
#pragma once

#include <string>

#include "panels/typing_limit.h"

namespace anamorph {

/// As wide as the column and at least so high, under the identity "##value". Returns whether the text was changed.
bool wrappedField(std::string& value, float height, TypingLimit& limit);

}  // namespace anamorph
