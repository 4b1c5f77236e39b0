// All that the commands say to a terminal goes through here. What comes from files, their names too, may hold what a
// terminal obeys (colours, the title of its window, a line that looks like one of ours): it is made fit where it is
// printed, so that errors and warnings need not care where they come from.
#pragma once

#include <cstdio>
#include <string_view>

#include "base/error.h"

namespace anamorph {

/// One line, printable() of the text. Throws Error when results cannot be written.
void printLine(std::FILE* to, std::string_view text);

/// All of an Error's faults on stderr, a line each.
void printError(const Error& error);

/// As it is: for what the program has made itself, or what other programs read (JSON). Throws likewise.
void printText(std::FILE* to, std::string_view text);

}  // namespace anamorph
