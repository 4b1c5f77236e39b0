// That all shaders compile, for OpenGL 3.3 and for WebGL 2, with every shape of a mirror.

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "cannot_run_here.h"
#include "gl/test_context.h"
#include "optics/shape_table.h"
#include "viewport/scene_program.h"

namespace anamorph::test {
namespace {

namespace fs = std::filesystem;

const fs::path shaderFolder = fs::path(ANAMORPH_SOURCE_DIR) / "shaders";

/// What a file is compiled with.
std::vector<ShaderOptions> variantsOf(const std::string& name) {
  std::vector<ShaderOptions> variants;
  for (const auto& entry : fs::directory_iterator(shaderFolder / "shapes")) {
    const std::string shape = entry.path().stem();
    variants.push_back(sceneOptions(shape));
    if (name == "scene_pass.frag.glsl") variants.push_back(sceneOptions(shape, {"TRACED", "GHOST", "WIRES"}));
    if (name != "scene_pass.frag.glsl" && name != "plain_mask.frag.glsl") break;  // they ask no mirror
  }
  return variants;
}

void expectAllCompile(Dialect dialect) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(shaderFolder)) {
    const std::string name = entry.path().filename();
    const bool vertex = name.ends_with(".vert.glsl");
    if (!vertex && !name.ends_with(".frag.glsl")) continue;
    for (const ShaderOptions& options : variantsOf(name)) {
      const ShaderText text = loadShaderText(shaderFolder, name, dialect, options);
      EXPECT_EQ(compileProblem(text, vertex ? ShaderStage::vertex : ShaderStage::fragment), "") << name;
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

class Shaders : public GlTest {};

TEST_F(Shaders, AllCompileForDesktop) {
  expectAllCompile(Dialect::desktop);
}

TEST_F(Shaders, AllCompileForWebGl2) {
  std::unique_ptr<OffscreenContext> es;
  std::string problem;
  OffscreenContext* const desktop = sharedContext(problem);
  try {
    es = std::make_unique<OffscreenContext>(GlKind::es);
  } catch (const Error& error) {
    desktop->makeCurrent();
    return cannotRunHere(error.what());
  }
  expectAllCompile(Dialect::es);
  es.reset();
  desktop->makeCurrent();
}

TEST_F(Shaders, EveryShapeHasItsFile) {
  for (const ShapeType& type : shapeTypes())
    EXPECT_TRUE(fs::exists(shaderFolder / "shapes" / (std::string(shaderOf(type.standard)) + ".glsl")))
        << type.name;
}

}  // namespace
}  // namespace anamorph::test
