// The mesh files that surfaces of a level are made of (optics/mesh_mirror.h): of its optic, and of the one that a frozen
// sculpture was made from. What is in them is read by pipeline/mirror_files.h.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "level/level.h"

namespace anamorph {

/// Lets `change` work on every one of them; shapes of which nothing is changed stay the same.
void changeSurfaceFiles(LevelScene& level, const std::function<void(SurfaceFile&)>& change);

/// Where the file lies: relative paths start at the level's folder.
std::filesystem::path surfacePath(const SurfaceFile& file, const std::filesystem::path& levelPath);

/// Where all of them lie.
std::vector<std::filesystem::path> surfaceFilesOf(const LevelScene& level,
                                                  const std::filesystem::path& levelPath);

}  // namespace anamorph
