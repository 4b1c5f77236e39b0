// A mesh file whose surface takes the mirror's place: read, and fitted into the box of the mirror that was there. One
// whose file was missing stays as it stood.
#pragma once

#include <filesystem>
#include <string>

#include "edit/edit_job.h"

namespace anamorph {

struct MirrorImport {
  std::string name;                 ///< of the file, as the level has it
  std::filesystem::path levelPath;  ///< empty: a level without a file
};

/// The level with that mirror, in one step. Throws Error when it cannot be read or used, and Cancelled as readFile does.
EditResult importMirror(const MirrorImport& import, const Level& level, const Progress& progress = {});

}  // namespace anamorph
