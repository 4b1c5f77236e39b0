#include "cli/print.h"

#include <cerrno>
#include <cstring>
#include <string>

#include "base/error.h"
#include "base/text.h"

namespace anamorph {

void printLine(std::FILE* to, std::string_view text) {
  printText(to, printable(text) + '\n');
}

void printText(std::FILE* to, std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), to) == text.size();
  if (!written && to == stdout) throw Error("cannot write: " + std::string(std::strerror(errno)), "stdout");
}

}  // namespace anamorph
