// A mesh file that takes the original's place: read, fitted into the place of what was there, and stood up where its y
// axis seems to be the one that points up.
#pragma once

#include <filesystem>
#include <string>

#include "edit/edit_job.h"
#include "math/box.h"

namespace anamorph {

struct MeshImport {
  std::filesystem::path file;
  std::string name;                 ///< of the file, as the level has it
  std::filesystem::path levelPath;  ///< empty: a level without a file
  Box box;                      ///< of the placed original that it replaces; empty where that is not known
  bool keepSize = false;        ///< of a scene of the thesis, which says where its mesh is and how it stands
  std::optional<ModelUp> up{};  ///< nothing: a guess
};

/// The level with the mesh, in two steps where it was stood up by a guess: undoing takes back the guess first. In place
/// of another mesh file it keeps that one's rotation and, where it can, its scale (withAnotherMesh); the same file read
/// again keeps the axis that points up, too. Throws Error, and Cancelled as readFile does.
EditResult importMesh(const MeshImport& import, const Level& level, const Progress& progress = {});

}  // namespace anamorph
