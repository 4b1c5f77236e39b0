// Results as JSON objects and as lines for people.
#pragma once

#include "exports/match_report_files.h"

namespace anamorph {

/// Object on stdout, indented.
void printJson(const JsonValue& value);

}  // namespace anamorph
