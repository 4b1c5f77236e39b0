// The message of the Error that a call throws, "no error" when it throws none.
#pragma once

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

}  // namespace anamorph
