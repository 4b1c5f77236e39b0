// Lines of text end at blanks, but not at those within a number with its unit, a size or a place.
#pragma once

#include <string>

namespace anamorph {

/// The text with blanks that keep together in "12 %", "0.8 mm", "58 x 21 x 56 mm" and "(1.0, 2.0, 3.0)".
std::string numbersTogether(const std::string& text);

}  // namespace anamorph
