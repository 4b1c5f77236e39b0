// Results as JSON objects and as lines for people.
#pragma once

#include <string>

#include "anamorphosis/match.h"
#include "level/json_object.h"

namespace anamorph {

/// {"mapped": 6146, "missesMirror": 0, ...}
JsonValue statusJson(const StatusCounts& counts);

/// {"size": ..., "silhouetteIou": ..., ...}; correspondencePx is null when no pixel could be compared.
JsonValue matchJson(const MatchReport& report, const StatusCounts& counts);

/// Object on stdout, indented.
void printJson(const JsonValue& value);

}  // namespace anamorph
