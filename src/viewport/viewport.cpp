#include "viewport/viewport.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glad/gl.h>

#include "base/check.h"
#include "base/language.h"
#include "gl/framebuffer.h"
#include "gl/gl_error.h"
#include "gl/shader.h"
#include "viewport/camera_model.h"
#include "viewport/overlay_pass.h"
#include "viewport/scene_block.h"
#include "viewport/scene_pass.h"
#include "viewport/scene_program.h"
#include "viewport/surface_store.h"

namespace anamorph {
namespace {

constexpr int lightUnit = 4, overlayUnit = 5;

/// Spreads evenly over the pixel however many are taken (Roberts 2018, the R2 sequence); the first is its
/// middle.
Pixel sampleShift(int sample) {
  const double x = 0.5 + sample * 0.7548776662466927, y = 0.5 + sample * 0.5698402909980532;
  return {x - std::floor(x) - 0.5, y - std::floor(y) - 0.5};
}

/// Others who draw in this context may have left anything.
void resetStates() {
  for (const GLenum state : {GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST, GL_SCISSOR_TEST, GL_STENCIL_TEST,
                             GL_DITHER, GL_POLYGON_OFFSET_FILL, GL_SAMPLE_ALPHA_TO_COVERAGE}) {
    glDisable(state);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glBlendEquation(GL_FUNC_ADD);
  constexpr GLuint units = 8;
  for (GLuint unit = 0; unit < units; ++unit) glBindSampler(unit, 0);
}

}  // namespace

struct Viewport::Parts {
  Parts() {
    resolve.use();
    resolve.set("light", lightUnit);
    resolve.set("overlay", overlayUnit);
    glGenVertexArrays(1, &noVertices);
  }
  ~Parts() { glDeleteVertexArrays(1, &noVertices); }

  void begin(const ViewportInput& wanted, double wantedScale);
  void addSample();
  void finish();

  // What is drawn, how large, and how far.
  ViewportInput input;
  double scale = 0;  // 0: nothing yet
  int done = 0, asked = 1;

  SurfaceStore surfaces;
  ScenePass scenePass;
  OverlayPass overlayPass;
  UniformBuffer block{sceneBlockPoint};
  ShaderProgram resolve = makeSceneProgram("full_screen.vert.glsl", "resolve.frag.glsl");
  Framebuffer picture;
  GLuint noVertices = 0;

  CameraModel cameraModel;
  SceneMeasure measure;
  Visible visible;
};

void Viewport::Parts::begin(const ViewportInput& wanted, double wantedScale) {
  input = wanted;
  scale = 0;  // until all is prepared: this may throw
  done = 0;
  measure = measureScene(boxOf(makeReflectionScene(input.level, input.sculpture)));
  SurfaceSources sources;
  sources[0] = {input.sculpture.prepared, input.sculpture.sculpture};
  sources[1] = {input.original, nullptr};
  sources[2] = {cameraModel.at(input.level.camera, rtCameraSize(input.level.grid, measure.radius)), nullptr};
  surfaces.update(sources);
  visible = findVisible(input, surfaces.slots(), measure.radius);
  scenePass.setScreen(input.screen);

  const auto scaled = [&](int size) {
    return std::max(1, static_cast<int>(std::lround(size * wantedScale)));
  };
  const int width = scaled(input.width), height = scaled(input.height);
  if (picture.width() != width || picture.height() != height) {
    picture = Framebuffer();
    picture = Framebuffer(width, height, {TexelFormat::rgba8}, false, true);
  }
  scenePass.resize(width, height);
  overlayPass.update(input, surfaces.slots(), visible, measure.centre, width, height);
  scale = wantedScale;
}

void Viewport::Parts::addSample() {
  const SceneBlock scene = makeSceneBlock(input, measure, surfaces.slots(), visible, picture.width(),
                                          picture.height(), sampleShift(done));
  block.write(&scene, sizeof scene);
  surfaces.bind();
  scenePass.draw(surfaces.slots(), visible, done);
  if (!overlayPass.empty())
    overlayPass.draw(input, scene, surfaces.slots(), visible, scenePass.depth(), input.lineScale * scale,
                     done);
  ++done;
}

void Viewport::Parts::finish() {
  picture.bind();
  scenePass.light().bind(lightUnit);
  if (!overlayPass.empty()) overlayPass.result().bind(overlayUnit);
  resolve.use();
  resolve.set("hasOverlay", overlayPass.empty() ? 0 : 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Viewport::Viewport() : parts_(std::make_unique<Parts>()) {
  checkGl("preparing the 3D view");
}

Viewport::~Viewport() = default;

bool Viewport::draw(const ViewportInput& input, double scale, int samplesNow, int samples) {
  CHECK(input.width > 0 && input.height > 0 && scale > 0 && scale <= 1 && samplesNow > 0 && samples > 0);
  Parts& p = *parts_;
  const SavedTarget saved;
  p.asked = samples;
  const bool changed = p.scale != scale || !(p.input == input);
  if (!changed && p.done >= samples) return false;
  resetStates();
  glBindVertexArray(p.noVertices);
  if (changed) p.begin(input, scale);
  for (const int end = std::min(p.done + samplesNow, samples); p.done < end;) p.addSample();
  p.finish();
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
  return true;
}

bool Viewport::complete() const {
  return parts_->scale > 0 && parts_->done >= parts_->asked;
}

std::uint32_t Viewport::texture() const {
  return parts_->picture.empty() ? 0 : parts_->picture.color().name();
}

Bitmap Viewport::readBack() const {
  const Framebuffer& picture = parts_->picture;
  return {picture.width(), picture.height(), 4, picture.readPixels()};
}

std::string Viewport::problem() const {
  std::string problem = parts_->surfaces.problem();
  if (parts_->input.level.lights.size() > gpuLightLimit) {
    problem += (problem.empty() ? "" : "; ") +
               trFormat("only the first {} lights are shown in the 3D view", gpuLightLimit);
  }
  return problem;
}

}  // namespace anamorph
