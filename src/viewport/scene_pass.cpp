#include "viewport/scene_pass.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <glad/gl.h>
#include <glm/vec4.hpp>

#include "viewport/scene_program.h"
#include "viewport/surface_store.h"

namespace anamorph {
namespace {

constexpr int seenUnit = 4, ghostUnit = 5, screenUnit = 6, sampleUnit = 4;

}  // namespace

SampleMean::SampleMean() : copy_(makeSceneProgram("full_screen.vert.glsl", "copy.frag.glsl")) {
  copy_.use();
  copy_.set("source", sampleUnit);
}

void SampleMean::resize(int width, int height, std::initializer_list<TexelFormat> formats, bool withDepth) {
  if (sample_.width() == width && sample_.height() == height) return;
  for (Framebuffer* old : {&sample_, &mean_}) *old = Framebuffer();  // before new ones, which are large
  sample_ = Framebuffer(width, height, formats, withDepth);
}

void SampleMean::beginSample(int number) {
  single_ = number == 0;
  if (number != 1) return;
  if (mean_.empty()) mean_ = Framebuffer(sample_.width(), sample_.height(), {TexelFormat::rgba16f});
  copySample();
}

void SampleMean::endSample(int number) {
  if (number == 0) return;
  glEnable(GL_BLEND);
  glBlendColor(0, 0, 0, 1.0f / static_cast<float>(number + 1));
  glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
  copySample();
  glDisable(GL_BLEND);
}

void SampleMean::copySample() const {
  mean_.bind();
  sample_.color().bind(sampleUnit);
  copy_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

ScenePass::ScenePass()
    : triangles_(makeSceneProgram("mesh.vert.glsl", "triangle_id.frag.glsl")),
      traced_(makeSceneProgram("full_screen.vert.glsl", "traced_id.frag.glsl")),
      screen_(TexelFormat::rgba32f, 1, 1) {
  const std::array<float, 4> black{};
  screen_.write(0, 0, 1, 1, black.data());
}

void ScenePass::resize(int width, int height) {
  mean_.resize(width, height, {TexelFormat::rgba16f, TexelFormat::r32f}, true);
  if (seen_.width() == width && seen_.height() == height) return;
  for (Framebuffer* old : {&seen_, &seenGhost_}) *old = Framebuffer();
  seen_ = Framebuffer(width, height, {TexelFormat::r32ui}, true);
}

void ScenePass::setScreen(const std::shared_ptr<const Image>& screen) {
  if (screen == shown_) return;
  shown_ = screen;
  if (!screen || screen->pixels.empty()) return;
  if (screen->width > Texture::maxSize() || screen->height > Texture::maxSize()) return;
  std::vector<glm::vec4> texels;
  texels.reserve(screen->pixels.size());
  for (const glm::vec3& pixel : screen->pixels) texels.emplace_back(pixel, 1);
  if (screen_.width() != screen->width || screen_.height() != screen->height) {
    screen_ = Texture(TexelFormat::rgba32f, screen->width, screen->height);
  }
  screen_.write(0, 0, screen->width, screen->height, texels.data());
}

void ScenePass::draw(const SurfaceSlots& slots, const Visible& visible, int number) {
  mean_.beginSample(number);
  findTriangles(seen_, slots, visible, false);
  if (visible.ghost) {
    if (seenGhost_.empty())
      seenGhost_ = Framebuffer(seen_.width(), seen_.height(), {TexelFormat::r32ui}, true);
    findTriangles(seenGhost_, slots, visible, true);
  }
  mean_.sample().bind();
  seen_.color().bind(seenUnit);
  if (visible.ghost) seenGhost_.color().bind(ghostUnit);
  screen_.bind(screenUnit);
  // What the first pass leaves out keeps the farthest depth, and only there the second one passes the depth
  // test.
  const GLfloat farthest = 1;
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  for (const bool traced : {false, true})
    drawPixels({visible.mirror, visible.ghost, visible.wires && traced, traced});
  glDisable(GL_DEPTH_TEST);
  mean_.endSample(number);
}

void ScenePass::drawPixels(const PixelProgram& kind) {
  ShaderProgram& program = programs_[kind];
  if (program.empty()) {
    std::vector<std::string> defines;
    if (kind.traced) defines.emplace_back("TRACED");
    if (kind.ghost) defines.emplace_back("GHOST");
    if (kind.wires) defines.emplace_back("WIRES");
    program =
        makeSceneProgram("full_screen.vert.glsl", "scene_pass.frag.glsl", sceneOptions(kind.mirror, defines));
    program.use();
    program.set("seen", seenUnit);
    program.set("seenGhost", ghostUnit);
    program.set("screen", screenUnit);
    program.set("place", kind.traced ? 1.0f : 0.0f);
  }
  program.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void ScenePass::findTriangles(const Framebuffer& target, const SurfaceSlots& slots, const Visible& visible,
                              bool ghost) {
  int surfaces = 0;
  std::int64_t triangles = 0;
  for (const GpuSurface surface : {GpuSurface::sculpture, GpuSurface::original, GpuSurface::rtCamera}) {
    const bool isGhost = surface == GpuSurface::original && visible.ghost;
    const int i = static_cast<int>(surface);
    if (!visible.surface(surface) || isGhost != ghost || slots[i].triangles == 0) continue;
    surfaces |= 1 << i;
    triangles += slots[i].triangles;
  }
  target.bind();
  if (fasterTraced(triangles, target)) {
    traced_.use();
    traced_.set("wanted", surfaces);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  } else {
    drawTriangles(slots, surfaces);
  }
}

void ScenePass::drawTriangles(const SurfaceSlots& slots, int surfaces) {
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  const std::array<GLuint, 4> nothing{};
  const GLfloat farthest = 1;
  glClearBufferuiv(GL_COLOR, 0, nothing.data());
  glClearBufferfv(GL_DEPTH, 0, &farthest);
  triangles_.use();
  for (int i = 0; i < gpuSurfaceCount; ++i) {
    if ((surfaces & 1 << i) == 0) continue;
    triangles_.set("surface", i);
    glDrawArrays(GL_TRIANGLES, 0, 3 * slots[i].triangles);
  }
  glDisable(GL_DEPTH_TEST);
}

}  // namespace anamorph
