// Levels and their files: which file a level may be saved to, how the mesh that it names is found from
// another place, a level as text for the clipboard.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "geometry/mesh.h"
#include "level/sent_level.h"

namespace anamorph {

/// The same however the path is written: without links in the folder's path, so that ".." can be counted; a link in the
/// file's own place stays one.
std::filesystem::path cleanPath(const std::filesystem::path& file);

/// Whether the file is one of those installed with the program, which nobody's work replaces.
bool isInstalledLevel(const std::filesystem::path& path);

/// How a level in the file `levelPath` names a mesh: relative to the level's folder, so that both can be moved together;
/// by its whole path where the two have no folder in common, and for a level without a file.
std::string meshNameFor(const std::filesystem::path& mesh, const std::filesystem::path& levelPath);

/// The level of the file `from` as it has to be in the file `to`, to find the same mesh. Nothing changes
/// within a folder. Either path may be empty: a level without a file.
Level withMeshFrom(Level level, const std::filesystem::path& from, const std::filesystem::path& to);

/// The mesh file that a level in the file `levelPath` names and that is not there; nothing when all is there.
std::optional<std::filesystem::path> findMissingMesh(const Level& level,
                                                     const std::filesystem::path& levelPath);

/// The level of the file `path` as text to be sent. Of a mesh's place it says what is below the level's folder, of others
/// only the file's name: the sender's folders are nobody's business.
std::string levelAsText(const Level& level, const std::filesystem::path& path);

/// The level with `mesh`, the one that its original's file has, z up, inside. Throws Error when that is larger than a level may
/// hold.
Level withMeshInside(Level level, const Mesh& mesh);

/// The level in a text, as it has to be in the file `path`, where the level `open` is. A mesh that is not there is taken
/// to be the one of `open` that has the same name. The meshes of mirrors are not read. Throws Error for a text that is
/// no level.
SentLevel levelFromText(const std::string& text, const Level& open, const std::filesystem::path& path);

}  // namespace anamorph
