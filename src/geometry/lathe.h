// Solids of revolution: a profile turned about the z axis.
#pragma once

#include <glm/vec2.hpp>

#include <span>

#include "geometry/mesh.h"

namespace anamorph {

/// `profile` holds (radius, z) from the bottom to the top with the outside on its right: the first and the
/// last point lie on the axis (radius 0), the others off it (radius > 0). `segments` >= 3 around. Closed and
/// outward.
Mesh makeLathe(std::span<const glm::dvec2> profile, int segments);

}  // namespace anamorph
