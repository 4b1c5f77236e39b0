#include "cli/report.h"

#include "cli/print.h"

namespace anamorph {

void printJson(const JsonValue& value) {
  printText(stdout, formatJson(value));
}

}  // namespace anamorph
