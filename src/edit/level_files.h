// Levels and their files: which file a level may be saved to, how the mesh that it names is found from
// another place, a level as text for the clipboard.
#pragma once

#include <filesystem>
#include <string>

#include "level/level.h"

namespace anamorph {

/// The same however the path is written: without links in the folder's path, so that ".." can be counted; a link in the
/// file's own place stays one.
std::filesystem::path cleanPath(const std::filesystem::path& file);

/// Whether the file is one of those installed with the program, which nobody's work replaces.
bool isInstalledLevel(const std::filesystem::path& path);

/// How a level in the file `levelPath` names a mesh: relative to the level's folder where the mesh lies in or
/// below it, else by its whole path; always for a level without a file.
std::string meshNameFor(const std::filesystem::path& mesh, const std::filesystem::path& levelPath);

/// The level of the file `from` as it has to be in the file `to`, to find the same mesh. Nothing changes
/// within a folder. Either path may be empty: a level without a file.
Level withMeshFrom(Level level, const std::filesystem::path& from, const std::filesystem::path& to);

/// The level of the file `path` as one line of JSON that means the same everywhere on this machine.
std::string levelAsText(const Level& level, const std::filesystem::path& path);

/// The level in a text, as it has to be in the file `path`. Throws Error for a text that is no level.
Level levelFromText(const std::string& text, const std::filesystem::path& path);

}  // namespace anamorph
