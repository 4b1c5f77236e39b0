// The shaders' leaf functions as C++: GLM has their types and functions, shader_constants.inl their constants. Such a
// function takes floats and vectors, returns a value or a struct, and reads no uniform.
#pragma once

#include <glm/glm.hpp>

#include "geometry/bvh_build.h"
#include "gl/texture.h"
#include "optics/optic.h"
#include "raytrace/look.h"
#include "raytrace/scene.h"
#include "viewport/line.h"
#include "viewport/scene_block.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace glsl_constants {
using vec3 = glm::vec3;
#define SHADER_CONSTANT(type, name, value) [[maybe_unused]] const type name = type(value);
#include "viewport/shader_constants.inl"
#undef SHADER_CONSTANT
}  // namespace glsl_constants

namespace glsl {
using namespace glm;
using namespace glsl_constants;

// In the order in which they need each other.
#include "../shaders/leaf/box.glsl"
#include "../shaders/leaf/marker.glsl"
#include "../shaders/leaf/shading.glsl"
#include "../shaders/leaf/tone.glsl"

#include "../shaders/leaf/ground.glsl"
#include "../shaders/leaf/triangle.glsl"

namespace plane {
#include "../shaders/shapes/plane.glsl"
}
namespace cylinder {
#include "../shaders/shapes/cylinder.glsl"
}
namespace cone {
#include "../shaders/shapes/cone.glsl"
}
namespace sphere {
#include "../shaders/shapes/sphere.glsl"
}
namespace ellipsoid {
#include "../shaders/shapes/ellipsoid.glsl"
}
namespace paraboloid {
#include "../shaders/shapes/paraboloid.glsl"
}

}  // namespace glsl

#pragma GCC diagnostic pop
