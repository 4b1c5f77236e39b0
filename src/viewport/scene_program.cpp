#include "viewport/scene_program.h"

#include <utility>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "geometry/bvh_build.h"
#include "gl/texture.h"
#include "optics/optic.h"
#include "raytrace/look.h"
#include "raytrace/scene.h"
#include "viewport/line.h"
#include "viewport/scene_block.h"
#include "viewport/surface_store.h"

namespace anamorph {
namespace {

using vec3 = glm::vec3;

std::string literal(int value) {
  return fmt::format("{}", value);
}
std::string literal(float value) {
  return fmt::format("{:#}", value);  // with a point
}
std::string literal(const vec3& v) {
  return fmt::format("vec3({:#}, {:#}, {:#})", v.x, v.y, v.z);
}

std::string makeConstants() {
  std::string text;
#define SHADER_CONSTANT(type, name, value) \
  text += fmt::format("const {} {} = {};\n", #type, #name, literal(type(value)));
#include "viewport/shader_constants.inl"
#undef SHADER_CONSTANT
  return text;
}

}  // namespace

ShaderOptions sceneOptions(const std::string& shape, std::vector<std::string> defines) {
  static const std::string constants = makeConstants();
  return {constants, std::move(defines), {{"SHAPE", "shapes/" + shape + ".glsl"}}};
}

ShaderProgram makeSceneProgram(const std::string& vertexFile, const std::string& fragmentFile,
                               const ShaderOptions& options) {
  ShaderProgram program(vertexFile, fragmentFile, options);
  program.use();
  program.bindBlock("Scene", sceneBlockPoint);
  program.set("nodes", SurfaceUnits::nodes);
  program.set("positions", SurfaceUnits::positions);
  program.set("triangles", SurfaceUnits::triangles);
  program.set("normals", SurfaceUnits::normals);
  return program;
}

}  // namespace anamorph
