// The message of the Error that a call throws, "no error" when it throws none.
#pragma once

#include <regex>
#include <string>

#include "base/error.h"

namespace anamorph {

template <typename Call>
std::string errorOf(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// The text without the "line 7, column 31: " before JSON pointers: where the lines of a made text end is not the matter.
inline std::string withoutPlaces(const std::string& text) {
  return std::regex_replace(text, std::regex("line [0-9]+, column [0-9]+: (?=/|expected|unknown)"), "");
}

}  // namespace anamorph
