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

SampleMean::SampleMean(std::initializer_list<TexelFormat> formats, bool withDepth)
    : formats_(formats),
      withDepth_(withDepth),
      copy_(makeSceneProgram("full_screen.vert.glsl", "copy.frag.glsl")) {
  copy_.use();
  copy_.set("source", sampleUnit);
}

void SampleMean::addBegin(Piecework& work, int number) {
  const Bands bands(size_);
  addFramebuffer(work, sample_, size_, formats_, withDepth_);
  if (number == 1) addFramebuffer(work, mean_, size_, {formats_.front()}, false);
  work.add(1, [this, number](int, int) { single_ = number == 0; });
  if (number == 1) work.add(bands.count(), [this, bands](int from, int to) { copySample(bands, from, to); });
}

void SampleMean::addEnd(Piecework& work, int number) {
  if (number == 0) return;
  const Bands bands(size_);
  work.add(bands.count(), [this, bands, number](int from, int to) {
    glEnable(GL_BLEND);
    glBlendColor(0, 0, 0, 1.0f / static_cast<float>(number + 1));
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    copySample(bands, from, to);
    glDisable(GL_BLEND);
  });
}

void SampleMean::copySample(const Bands& bands, int from, int to) const {
  mean_.bind();
  sample_.color().bind(sampleUnit);
  copy_.use();
  bands.draw(from, to, drawFullScreen);
}

ScenePass::ScenePass()
    : triangles_(makeSceneProgram("mesh.vert.glsl", "triangle_id.frag.glsl")),
      traced_(makeSceneProgram("full_screen.vert.glsl", "traced_id.frag.glsl")),
      screen_(TexelFormat::rgba32f, 1, 1) {
  const std::array<float, 4> black{};
  screen_.write(0, 0, 1, 1, black.data());
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

void ScenePass::add(Piecework& work, const SurfaceSlots& slots, const Visible& visible, int number) {
  mean_.addBegin(work, number);
  addTriangles(work, seen_, slots, visible, false);
  if (visible.ghost) addTriangles(work, seenGhost_, slots, visible, true);
  addPixels(work, visible);
  mean_.addEnd(work, number);
}

void ScenePass::addPixels(Piecework& work, const Visible& visible) {
  const std::array programs{PixelProgram{{visible.mirror, visible.ghost, false}, false},
                            PixelProgram{visible, true}};
  const Bands bands(mean_.size());
  // What the first kind leaves out keeps the farthest depth, and only there the second one passes the depth test.
  work.add(bands.count(), [this, bands](int from, int to) {
    mean_.sample().bind();
    const GLfloat farthest = 1;
    bands.draw(from, to, [&] { glClearBufferfv(GL_DEPTH, 0, &farthest); });
  });
  for (const PixelProgram& kind : programs) {
    work.add(1, [this, kind](int, int) { make(kind); });
    work.add(bands.count(), [this, kind, bands](int from, int to) {
      mean_.sample().bind();
      seen_.color().bind(seenUnit);
      if (kind.kinds.ghost) seenGhost_.color().bind(ghostUnit);
      screen_.bind(screenUnit);
      glEnable(GL_DEPTH_TEST);
      glDepthFunc(GL_LEQUAL);
      programs_[kind].use();
      bands.draw(from, to, drawFullScreen);
      glDisable(GL_DEPTH_TEST);
    });
  }
}

void ScenePass::make(const PixelProgram& kind) {
  ShaderProgram& program = programs_[kind];
  if (!program.empty()) return;
  std::vector<std::string> defines;
  if (kind.traced) defines.emplace_back("TRACED");
  if (kind.kinds.ghost) defines.emplace_back("GHOST");
  if (kind.kinds.wires) defines.emplace_back("WIRES");
  program = makeSceneProgram("full_screen.vert.glsl", "scene_pass.frag.glsl",
                             sceneOptions(kind.kinds.mirror, defines));
  program.use();
  program.set("seen", seenUnit);
  program.set("seenGhost", ghostUnit);
  program.set("screen", screenUnit);
  program.set("place", kind.traced ? 1.0f : 0.0f);
}

void ScenePass::addTriangles(Piecework& work, Framebuffer& target, const SurfaceSlots& slots,
                             const Visible& visible, bool ghost) {
  int surfaces = 0;
  std::int64_t triangles = 0;
  for (const GpuSurface surface : {GpuSurface::sculpture, GpuSurface::original, GpuSurface::rtCamera}) {
    const bool isGhost = surface == GpuSurface::original && visible.ghost;
    const int i = static_cast<int>(surface);
    if (!visible.surface(surface) || isGhost != ghost || slots[i].triangles == 0) continue;
    surfaces |= 1 << i;
    triangles += slots[i].triangles;
  }
  const PixelSize& size = mean_.size();
  addFramebuffer(work, target, size, {TexelFormat::r32ui}, true);
  if (!fasterTraced(triangles, std::int64_t{size.width} * size.height))
    return addDrawnTriangles(work, target, slots, surfaces);
  const Bands bands(size);
  work.add(bands.count(), [this, &target, surfaces, bands](int from, int to) {
    target.bind();
    traced_.use();
    traced_.set("wanted", surfaces);
    bands.draw(from, to, drawFullScreen);
  });
}

void ScenePass::addDrawnTriangles(Piecework& work, const Framebuffer& target, const SurfaceSlots& slots,
                                  int surfaces) {
  work.add(1, [&target](int, int) {
    target.bind();
    const std::array<GLuint, 4> nothing{};
    const GLfloat farthest = 1;
    glClearBufferuiv(GL_COLOR, 0, nothing.data());
    glClearBufferfv(GL_DEPTH, 0, &farthest);
  });
  for (int i = 0; i < gpuSurfaceCount; ++i) {
    if ((surfaces & 1 << i) == 0) continue;
    const ListPieces triangles = trianglePieces(slots[i].triangles);
    work.add(triangles.count(), [this, &target, i, triangles](int from, int to) {
      target.bind();
      glEnable(GL_DEPTH_TEST);
      glDepthFunc(GL_LEQUAL);
      triangles_.use();
      triangles_.set("surface", i);
      drawTriangles(triangles, from, to);
      glDisable(GL_DEPTH_TEST);
    });
  }
}

}  // namespace anamorph
