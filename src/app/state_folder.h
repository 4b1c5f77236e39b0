// Where the program keeps what it remembers by itself, unlike preferences that people choose: progress,
// recovery files.
#pragma once

#include <filesystem>

namespace anamorph {

/// $XDG_STATE_HOME/anamorph, else ~/.local/state/anamorph. Need not exist.
std::filesystem::path stateFolder();

}  // namespace anamorph
