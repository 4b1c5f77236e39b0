// The RT camera as a thing in the scene: how large it is drawn, and where it is hit.
#pragma once

#include <optional>

#include "level/level.h"
#include "math/box.h"
#include "math/ray.h"

namespace anamorph {

/// What the drawn model fills, in units of its size: x right, y up, z forward; the eye is at 0.
inline const Box rtCameraBody{{-0.62, -0.54, -1.95}, {0.62, 0.68, 0}};

/// Half the length of the model, scene units. It follows the scene in steps, so that the model is seldom made anew while
/// something moves.
double rtCameraSize(const PixelGrid& grid, double sceneRadius);

/// Where along the ray (in lengths of its direction) its body is hit from outside; nothing for a miss.
std::optional<double> intersectRtCamera(const Camera& camera, double size, const Ray& ray);

}  // namespace anamorph
