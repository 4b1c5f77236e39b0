// Quarter turns of the original, for models that do not stand as they should. Each turns the original in place: about the
// middle of its box, and then up or down until it stands as high as it stood.
#pragma once

#include "geometry/mesh.h"
#include "geometry/model_up.h"
#include "level/level.h"

namespace anamorph {

/// A quarter turn about one of the scene's axes (0 to 2), counter-clockwise seen from its tip. `placed` is the original in
/// scene coordinates; the level itself for an empty one.
Level turnedQuarter(const Level& level, int axis, const Mesh& placed);

/// Another axis of the original's mesh file up. The level itself when the original is no mesh file, or empty.
Level withModelUp(const Level& level, ModelUp up, const Mesh& placed);

/// The axis to try after `up`: z, y, -y, x and z again.
ModelUp nextModelUp(ModelUp up);

}  // namespace anamorph
