// A level whose mesh is not to be had: whoever has it shows where it is, the others look at something else meanwhile.
#pragma once

#include <filesystem>
#include <optional>

#include "level/level.h"
#include "panels/keys.h"
#include "panels/look.h"

namespace anamorph {

/// What waits for an answer because a mesh cannot be read.
struct MeshQuestion {
  enum class Answer { browse, standIn, cancel };
  Level level;                 ///< that takes the place of the session's, with a mesh that is there
  std::filesystem::path mesh;  ///< where it should be
};

/// Returns the answer when one was given.
std::optional<MeshQuestion::Answer> drawMeshDialog(const MeshQuestion& question, const DialogKeys& typed,
                                                   const Look& look);

}  // namespace anamorph
