#include "cli/print.h"

#include <string>

#include "base/system_call.h"
#include "base/text.h"

namespace anamorph {

void printLine(std::FILE* to, std::string_view text) {
  printText(to, printable(text) + '\n');
}

void printError(const Error& error) {
  for (const std::string& line : linesOf(error)) printLine(stderr, line);
}

void printText(std::FILE* to, std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), to) == text.size();
  if (!written && to == stdout) throw Error("cannot write: " + systemReason(), "stdout");
}

}  // namespace anamorph
