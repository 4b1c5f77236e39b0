// A level as text that people send each other: by mail, in a chat, quoted in an answer.
//
//   written   one line of plain ASCII without blanks inside its strings, so that what wrapped or quoted it can be told
//   read      Hello, look at this:              the words around the outermost braces are left out
//             > ```
//             > {"title": "The\u0020mir         the marks of quoting are taken away
//             > ror", "optic": ...}             line ends inside strings and numbers are taken out
//
// In a text that somebody else made, a file's for example, strings have blanks: there a line end stands for one.
#pragma once

#include <string>
#include <string_view>

#include "level/level.h"

namespace anamorph {

/// What had to be mended of a text.
struct TextMends {
  bool wordsAround = false;  ///< that were left out
  bool quoting = false;      ///< marks that were taken away
  bool lineEnds = false;     ///< that were taken out of strings and numbers
  bool operator==(const TextMends&) const = default;
};

struct SentLevel {
  Level level;
  TextMends mends;
};

/// The level as it is; readSentLevel gives the same again.
std::string formatSentLevel(const Level& level);

/// The level in a text. Throws Error for a text without one, for one that was cut off, and for a scene of the thesis;
/// `name` is what messages call the text.
SentLevel readSentLevel(std::string_view text, const std::string& name);

}  // namespace anamorph
