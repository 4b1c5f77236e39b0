// How far the sculpture of the level is, in everyday words, for the status line.
#pragma once

#include "pipeline/level_result.h"

namespace anamorph {

/// English, to be shown through tr(). `busy`: something is being computed, or will be.
const char* stateWords(const LevelResult& result, bool busy);

}  // namespace anamorph
