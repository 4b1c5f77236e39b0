// A small model of the RT camera, to see in the 3D view where the eye is: a box with a lens hood whose
// opening is at the eye.
#pragma once

#include "pipeline/stages.h"

namespace anamorph {

/// In scene coordinates, about 2 * size long, behind the eye.
PreparedMesh makeCameraModel(const Camera& camera, double size);

}  // namespace anamorph
