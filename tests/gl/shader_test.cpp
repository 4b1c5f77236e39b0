// Shaders: how they are put together, and that complaints name the right line.

#include <unistd.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "base/file.h"
#include "gl/shader.h"
#include "gl/test_context.h"

namespace anamorph::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

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
  const ShaderText text = loadShaderText(folder_, "main.glsl", Dialect::desktop, {{}, {"NUMBER 2.0"}, {}});
  EXPECT_EQ(compileProblem(text, ShaderStage::fragment), "");
}

TEST_F(Shader, APreludeLeavesLineNumbersRight) {
  write("main.glsl", "out vec4 c;\nvoid main() { c = vec4(half_); }\n");
  const ShaderText text =
      loadShaderText(folder_, "main.glsl", Dialect::desktop, {"const float half_ = 0.5;\n", {}, {}});
  EXPECT_EQ(compileProblem(text, ShaderStage::fragment), "");
  const ShaderText other =
      loadShaderText(folder_, "main.glsl", Dialect::desktop, {"const float x = 0.5;\n\n", {}, {}});
  EXPECT_THAT(compileProblem(other, ShaderStage::fragment), HasSubstr("main.glsl:2"));
}

TEST_F(Shader, AFileMayBeChosenByTheCaller) {
  write("one.glsl", "float value() { return 1.0; }\n");
  write("main.glsl", "#include VALUE\nout vec4 c;\nvoid main() { c = vec4(value()); }\n");
  const ShaderText text =
      loadShaderText(folder_, "main.glsl", Dialect::desktop, {{}, {}, {{"VALUE", "one.glsl"}}});
  EXPECT_EQ(compileProblem(text, ShaderStage::fragment), "");
  EXPECT_THROW(loadShaderText(folder_, "main.glsl", Dialect::desktop), Error);
}

TEST_F(Shader, MissingFileIsAnError) {
  write("main.glsl", "#include \"nowhere.glsl\"\n");
  EXPECT_THROW(loadShaderText(folder_, "main.glsl", Dialect::desktop), Error);
  EXPECT_THROW(ShaderProgram("nowhere.glsl", "nowhere.glsl"), Error);
}

}  // namespace
}  // namespace anamorph::test
