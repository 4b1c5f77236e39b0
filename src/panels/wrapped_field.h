// A row with a field of several lines of text. Dear ImGui's own does not wrap: so what is not being typed is shown wrapped, and a
// click, or Enter, begins typing.
#pragma once

#include <cstddef>
#include <string>

namespace anamorph {

/// As wide as the column, at least so many lines high; takes at most `most` bytes. Returns whether the text was changed.
bool wrappedFieldRow(const char* name, std::string& value, std::size_t most, int lines, const char* help);

}  // namespace anamorph
