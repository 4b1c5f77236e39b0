// Shaders: that all of them compile for OpenGL 3.3 and for WebGL 2, and that complaints name the right line.

#include <unistd.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <string>

#include "base/file.h"
#include "cannot_run_here.h"
#include "gl/shader.h"
#include "gl/test_context.h"

namespace anamorph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path shaderFolder = fs::path(ANAMORPH_SOURCE_DIR) / "shaders";

using Defines = std::vector<std::string>;

/// What a file is compiled with.
std::vector<Defines> variantsOf(const std::string& name) {
  if (name != "scene_pass.frag.glsl") return {{}};
  std::vector<Defines> variants;
  for (const char* kind : {"0", "1", "2", "3"}) {
    const std::string mirror = std::string("MIRROR_KIND ") + kind;
    variants.push_back({mirror});
    variants.push_back({mirror, "TRACED", "GHOST", "WIRES"});
  }
  return variants;
}

void expectAllCompile(Dialect dialect) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(shaderFolder)) {
    const std::string name = entry.path().filename();
    const bool vertex = name.ends_with(".vert.glsl");
    if (!vertex && !name.ends_with(".frag.glsl")) continue;
    for (const Defines& defines : variantsOf(name)) {
      const ShaderText text = loadShaderText(shaderFolder, name, dialect, defines);
      EXPECT_EQ(compileProblem(text, vertex ? ShaderStage::vertex : ShaderStage::fragment), "") << name;
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

class Shader : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    fs::create_directories(folder_);
  }
  void TearDown() override {
    GlTest::TearDown();
    fs::remove_all(folder_);
  }
  void write(const std::string& name, const std::string& text) { writeFile(folder_ / name, text); }
  std::string problemOf(const std::string& name) {
    return compileProblem(loadShaderText(folder_, name, Dialect::desktop), ShaderStage::fragment);
  }

  const fs::path folder_ = fs::path(testing::TempDir()) / ("anamorph-shaders-" + std::to_string(::getpid()));
};

TEST_F(Shader, AllCompileForDesktop) {
  expectAllCompile(Dialect::desktop);
}

TEST_F(Shader, AllCompileForWebGl2) {
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

TEST_F(Shader, IncludesComeInOnce) {
  write("one.glsl", "float one() { return 1.0; }\n");
  write("two.glsl", "#include \"one.glsl\"\nfloat two() { return 2.0 * one(); }\n");
  write("main.glsl",
        "#include \"one.glsl\"\n#include \"two.glsl\"\nout vec4 c;\nvoid main() { c = vec4(two()); }\n");
  EXPECT_EQ(problemOf("main.glsl"), "");
  EXPECT_EQ(loadShaderText(folder_, "main.glsl", Dialect::desktop).files.size(), 3u);
}

TEST_F(Shader, ComplaintsNameFileAndLine) {
  write("broken.glsl", "float fine() { return 1.0; }\n\nfloat broken() { return nonsense; }\n");
  write("main.glsl", "#include \"broken.glsl\"\nout vec4 c;\nvoid main() { c = vec4(fine()); }\n");
  EXPECT_THAT(problemOf("main.glsl"), HasSubstr("broken.glsl:3"));
  write("late.glsl", "float fine() { return 1.0; }\n");
  write("main.glsl", "#include \"late.glsl\"\nout vec4 c;\nvoid main() { c = wrong; }\n");
  EXPECT_THAT(problemOf("main.glsl"), HasSubstr("main.glsl:3"));
}

TEST_F(Shader, DefinesReachTheSource) {
  write("main.glsl", "out vec4 c;\nvoid main() { c = vec4(NUMBER); }\n");
  EXPECT_NE(problemOf("main.glsl"), "");
  const ShaderText text = loadShaderText(folder_, "main.glsl", Dialect::desktop, {"NUMBER 2.0"});
  EXPECT_EQ(compileProblem(text, ShaderStage::fragment), "");
}

TEST_F(Shader, MissingFileIsAnError) {
  write("main.glsl", "#include \"nowhere.glsl\"\n");
  EXPECT_THROW(loadShaderText(folder_, "main.glsl", Dialect::desktop), Error);
  EXPECT_THROW(ShaderProgram("nowhere.glsl", "nowhere.glsl"), Error);
}

}  // namespace
}  // namespace anamorph::test
