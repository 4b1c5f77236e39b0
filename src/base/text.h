// Words for messages: lists, and texts of strangers (files, names of files) made fit to be shown.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace anamorph {

/// "a, b or c"; `word`: the "or" of the language.
std::string alternatives(const std::vector<std::string>& texts, const std::string& word = "or");

/// The text, and what else there is to say of it: "text; a; b"
std::string withRemarks(std::string text, const std::vector<std::string>& remarks);
/// The bytes of the well-formed UTF-8 character that the text begins with; 0 when it begins with none.
std::size_t characterLength(std::string_view text);

/// At most `most` bytes of the text, cut between characters, never inside one; "..." tells of a cut.
std::string shortened(std::string text, std::size_t most);

/// The text as a terminal may have it, in one line: control characters, what turns the direction of writing, and bytes
/// that are not UTF-8 become \n, \t or octal, \033, as git and ls write them. Everything else stays as it is.
std::string printable(std::string_view text);

}  // namespace anamorph
