// The numbers of the studio's look: what makes a picture readable without changing what it says. The tracer and
// the 3D view's shaders use the same ones (viewport/shader_constants.inl).
#pragma once

#include "math/vec.h"

namespace anamorph::look {

constexpr double fadeStart = 1.2, fadeEnd = 5;  ///< of the ground: radii of the scene, along the ground
constexpr double gridLineWidth = 0.018;         ///< of the ground's grid, in its spacings
constexpr double gridDarkening = 0.28;          ///< of the ground's colour on a line
constexpr double leastSlant = 0.02;             ///< of a ray on the ground: a pixel is no wider there

constexpr double rimCosine = 0.22;   ///< a mirror seen more edge-on than this begins to shine
constexpr double rimBorder = 0.006;  ///< as does its border, as wide as this fraction of its size
constexpr double rimStrength = 0.7;
constexpr Color rimColor{0.98, 0.99, 1};

constexpr double shoulderStart = 0.75;  ///< of the tone curve: light above it is compressed

}  // namespace anamorph::look
