// What of a lesson can be read, but will not work: `anamorph check` tells of it, the window opens the level all the
// same. Whether a text is true only its author knows.
#pragma once

#include <cstddef>

#include "level/file_remarks.h"
#include "level/level_json.h"

namespace anamorph {

/// Faults of a level's lesson: a control that the window has not got, a vertex that the original (of so many) or a pixel
/// that the grid has not got, and a move of "Do it" after which its step cannot be done.
void checkLesson(const LoadedLevel& loaded, std::size_t vertices, FileRemarks& remarks);

}  // namespace anamorph
