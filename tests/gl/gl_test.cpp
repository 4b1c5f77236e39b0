// The thin layer over OpenGL: contexts, textures, framebuffers, timers.

#include <glad/gl.h>
#include <gmock/gmock.h>

#include <array>
#include <cstring>
#include <numeric>
#include <optional>

#include "gl/framebuffer.h"
#include "gl/shader.h"
#include "gl/test_context.h"
#include "gl/timer.h"

namespace anamorph::test {
namespace {

using Gl = GlTest;

TEST_F(Gl, NamesItsRenderer) {
  EXPECT_FALSE(rendererName().empty());
  if (rendererName().find("llvmpipe") != std::string::npos) {
    EXPECT_TRUE(isSoftwareRenderer());
  }
}

TEST_F(Gl, RefusesADriverWithoutFunctions) {
  const GlGetter nothing = [](const char*) -> void (*)() { return nullptr; };
  EXPECT_THROW(loadGl(nothing), Error);
  std::string problem;
  sharedContext(problem)->makeCurrent();  // the functions are lost
}

TEST_F(Gl, ReportsErrorsByName) {
  glEnable(0x1234);
  EXPECT_EQ(takeGlErrors(), "GL_INVALID_ENUM");
  glEnable(0x1234);
  try {
    checkGl("a test");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("GL_INVALID_ENUM"), testing::HasSubstr("a test")));
  }
  EXPECT_NO_THROW(checkGl("a test"));
}

TEST_F(Gl, ContextsCanBeMadeAgain) {
  for (int i = 0; i < 3; ++i) {
    const OffscreenContext other;
    EXPECT_FALSE(rendererName().empty());
  }
  std::string problem;
  sharedContext(problem)->makeCurrent();
}

std::vector<float> readFloats(const Texture& texture, int width, int height) {
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.name(), 0);
  std::vector<float> result(4 * static_cast<std::size_t>(width) * height);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, result.data());
  glDeleteFramebuffers(1, &framebuffer);
  return result;
}

TEST_F(Gl, PixelsAreReadFromTheTop) {
  for (const int height : {1, 2, 3}) {
    const Framebuffer target(2, height, {TexelFormat::rgba8});
    std::vector<std::uint8_t> texels(8 * static_cast<std::size_t>(height));
    std::iota(texels.begin(), texels.end(), std::uint8_t{1});
    target.bind();
    glEnable(GL_SCISSOR_TEST);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < 2; ++x) {
        glScissor(x, height - 1 - y, 1, 1);
        const std::uint8_t* p = &texels[4 * static_cast<std::size_t>(2 * y + x)];
        glClearColor(float(p[0]) / 255, float(p[1]) / 255, float(p[2]) / 255, float(p[3]) / 255);
        glClear(GL_COLOR_BUFFER_BIT);
      }
    }
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    EXPECT_EQ(target.readPixels(), texels);
    GLint bound = -1;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &bound);
    EXPECT_EQ(bound, 0) << "what was bound is bound";
  }
  EXPECT_TRUE(Framebuffer().readPixels().empty());
}

TEST_F(Gl, TexturesTakeRectangles) {
  Texture texture(TexelFormat::rgba32f, 4, 3);
  const std::vector<float> black(48, 0);
  texture.write(0, 0, 4, 3, black.data());
  const std::vector<float> white(8, 1);
  texture.write(1, 2, 2, 1, white.data());
  const std::vector<float> texels = readFloats(texture, 4, 3);
  EXPECT_EQ(std::accumulate(texels.begin(), texels.end(), 0.0f), 8);
  EXPECT_EQ(texels[4 * (2 * 4 + 1)], 1);
}

TEST_F(Gl, MakingATextureLeavesWhatIsBound) {
  const Texture bound(TexelFormat::rgba8, 1, 1);
  bound.bind(3);
  Texture other(TexelFormat::rgba8, 2, 2);
  other.write(0, 0, 1, 1, "abcd");
  const Framebuffer framebuffer(2, 2, {TexelFormat::rgba8}, true);
  glActiveTexture(GL_TEXTURE3);
  GLint name = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &name);
  EXPECT_EQ(static_cast<GLuint>(name), bound.name());
}

TEST_F(Gl, TexelArraysKeepTheirPlaces) {
  TexelArrays arrays(TexelFormat::rgba32f, 3);
  constexpr std::size_t row = TexelArrays::rowLength;
  EXPECT_TRUE(arrays.reserve(std::array<std::size_t, 3>{row + 1, 0, 5}));
  EXPECT_EQ(arrays.first(0), 0);
  EXPECT_EQ(arrays.first(1), 2 * static_cast<int>(row));
  EXPECT_EQ(arrays.first(2), 2 * static_cast<int>(row));
  EXPECT_FALSE(arrays.reserve(std::array<std::size_t, 3>{2 * row, 0, 1})) << "there is room";
  EXPECT_TRUE(arrays.moved());
  arrays.make();
  EXPECT_FALSE(arrays.moved());
  std::vector<float> texels(4 * (row + 1));
  std::iota(texels.begin(), texels.end(), 0.0f);
  arrays.write(0, 0, texels.data(), row + 1);
  EXPECT_TRUE(arrays.reserve(std::array<std::size_t, 3>{2 * row + 1, 0, 1}));
}

TEST_F(Gl, TexelArraysKnowTheLimit) {
  const std::size_t most = static_cast<std::size_t>(Texture::maxSize()) * TexelArrays::rowLength;
  EXPECT_TRUE(TexelArrays::fits(std::array<std::size_t, 2>{most - TexelArrays::rowLength, 1}));
  EXPECT_FALSE(TexelArrays::fits(std::array<std::size_t, 2>{most, 1}));
  EXPECT_FALSE(TexelArrays::fits(std::array<std::size_t, 1>{~std::size_t{0} / 2}));
}

TEST_F(Gl, FramebuffersOfEveryFormatCanBeDrawnInto) {
  for (const TexelFormat format : {TexelFormat::rgba8, TexelFormat::r8, TexelFormat::rgba16f,
                                   TexelFormat::r32f, TexelFormat::rgba32f, TexelFormat::r32ui}) {
    const Framebuffer framebuffer(5, 4, {format}, true);
    framebuffer.bind();
    EXPECT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), static_cast<GLenum>(GL_FRAMEBUFFER_COMPLETE));
  }
}

TEST_F(Gl, SavedTargetGoesBack) {
  const Framebuffer outer(7, 6, {TexelFormat::rgba8}), inner(3, 2, {TexelFormat::rgba8});
  outer.bind();
  {
    const SavedTarget saved;
    inner.bind();
  }
  GLint target = 0, viewport[4] = {};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  glGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT_EQ(static_cast<GLuint>(target), outer.name());
  EXPECT_EQ(viewport[2], 7);
  EXPECT_EQ(viewport[3], 6);
}

TEST_F(Gl, TimerTellsMilliseconds) {
  GpuTimer timer;
  EXPECT_EQ(timer.result(), 0);
  const Framebuffer framebuffer(256, 256, {TexelFormat::rgba8});
  framebuffer.bind();
  timer.begin();
  const GLfloat color[] = {0.5f, 0.5f, 0.5f, 1};
  for (int i = 0; i < 20; ++i) glClearBufferfv(GL_COLOR, 0, color);
  timer.end();
  EXPECT_GE(timer.waitForResult(), 0);
  EXPECT_LT(timer.waitForResult(), 10000);
  timer.begin();
  timer.begin();  // does nothing
  timer.end();
  timer.end();
  EXPECT_GE(timer.waitForResult(), 0);
}

}  // namespace
}  // namespace anamorph::test
