// Where shaders, assets and levels lie: in the source tree while developing, under share/anamorph when installed.
#pragma once

#include <filesystem>

namespace anamorph {

/// The folder that holds `levels/`, `shaders/` and `assets/`. Searched in this order: $ANAMORPH_RESOURCES,
/// <program>/../share/anamorph, the source tree the program was built from. Throws Error when none has them.
std::filesystem::path resourceFolder();

}  // namespace anamorph
