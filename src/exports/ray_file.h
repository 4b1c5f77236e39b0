// Rays as lines in a Wavefront OBJ file, to lay over the sculpture in a 3D program: `v` lines and `l` lines,
// one object for each kind of ray, so that each can have its own colour there.
#pragma once

#include <string>

#include "base/progress.h"
#include "pipeline/picture.h"

namespace anamorph {

/// The vertex rays E - Q - S of `count` vertices of the original, evenly over its list (all, when it has
/// fewer): one line through three points each, in millimetres. Those that are not mapped are left out and
/// counted in the head. Nothing when cancelled.
std::optional<std::string> makeVertexRayObj(const LevelResult& finished, int count, double millimetresPerUnit,
                                            const Progress& progress = {});

/// The ray trees of the RT camera's pixel grid, one ray through the middle of each cell: a line for every
/// ray, in one object a kind. Nothing when cancelled.
std::optional<std::string> makePixelRayObj(const LevelResult& finished, double millimetresPerUnit,
                                           const Progress& progress = {});

}  // namespace anamorph
