// The meshes of mirrors are read once, when their level is: by the open job, the command line, a restore, a paste. A file
// that cannot be read is no Error here: the level opens, and its mirror says what is wrong (findShapeProblem).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "geometry/mesh_limits.h"
#include "level/level.h"

namespace anamorph {

/// Reads what has not been read; the level is in the file `levelPath`. Returns what there is to say of the files, whole
/// sentences. Throws Cancelled as readFile does.
std::vector<std::string> readMirrorFiles(LevelScene& level, const std::filesystem::path& levelPath,
                                         const MeshLimits& limits = {}, const CancelToken* token = nullptr);

/// Takes the meshes that another level has read already, where the paths are the same. Returns whether there are others.
bool takeMirrorFiles(LevelScene& level, const LevelScene& known);

}  // namespace anamorph
