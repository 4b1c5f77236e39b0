#include "cli/report.h"

#include <fmt/format.h>

namespace anamorph {

void printJson(const JsonValue& value) {
  fmt::print("{}", formatJson(value));
}

}  // namespace anamorph
