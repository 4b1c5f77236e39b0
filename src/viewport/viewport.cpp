#include "viewport/viewport.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glad/gl.h>

#include "base/check.h"
#include "base/language.h"
#include "edit/camera_body.h"
#include "gl/framebuffer.h"
#include "gl/gl_error.h"
#include "gl/shader.h"
#include "viewport/bands.h"
#include "viewport/camera_model.h"
#include "viewport/mirror_model.h"
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

  bool mustFinish() const;
  void begin(const ViewportInput& wanted, double wantedScale);
  void drawFor(int end, double milliseconds);
  void addSample(bool show);
  void addShow();

  // What is drawn, how large, and how far.
  ViewportInput input;
  double scale = 0;  // 0: nothing yet
  PixelSize size;
  int done = 0, asked = 1;
  Piecework work{[] { glFinish(); }};
  bool behind = false;  // what the last call asked for waits until this input is shown
  double spent = 0;     // milliseconds, on the sample that is being drawn
  std::optional<SampleCost> cost;

  SurfaceStore surfaces;
  ScenePass scenePass;
  OverlayPass overlayPass;
  UniformBuffer block{sceneBlockPoint};
  ShaderProgram resolve = makeSceneProgram("full_screen.vert.glsl", "resolve.frag.glsl");
  Framebuffer picture, nextPicture;  // shown, and on the way
  ViewportInput shown;               // in the picture
  GLuint noVertices = 0;

  CameraModel cameraModel;
  MirrorModel mirrorModel;
  SceneMeasure measure;
  Visible visible;
};

bool Viewport::Parts::mustFinish() const {
  return scale > 0 && !work.empty() && !(shown == input);
}

void Viewport::Parts::begin(const ViewportInput& wanted, double wantedScale) {
  work.clear();
  input = wanted;
  scale = 0;  // until all is prepared: this may throw
  done = 0;
  measure = measureScene(boxOf(makeReflectionScene(input.level, input.sculpture)));
  SurfaceSources sources;
  sources[0] = {input.sculpture.prepared, input.sculpture.sculpture};
  sources[1] = {input.original, nullptr};
  sources[2] = {cameraModel.at(input.level.camera, rtCameraSize(input.level.grid, measure.radius)), nullptr};
  const MirrorTriangles& mirror = mirrorModel.at(input);
  sources[3] = {mirror.prepared, nullptr, mirror.borders};
  surfaces.update(sources, work);
  visible = findVisible(input, surfaces.slots(), measure.radius);
  scenePass.setScreen(input.screen);

  const auto scaled = [&](int pixels) {
    return std::max(1, static_cast<int>(std::lround(pixels * wantedScale)));
  };
  size = {scaled(input.width), scaled(input.height)};
  scenePass.resize(size);
  overlayPass.update(input, surfaces.slots(), visible, measure.centre, size);
  scale = wantedScale;
}

// `show`: its end is to be seen.
void Viewport::Parts::addSample(bool show) {
  const SceneBlock scene =
      makeSceneBlock(input, measure, surfaces.slots(), visible, size.width, size.height, sampleShift(done));
  work.add(1, [this, scene](int, int) {
    spent = 0;
    block.write(&scene, sizeof scene);
  });
  scenePass.add(work, surfaces.slots(), visible, done);
  if (!overlayPass.empty()) {
    overlayPass.add(work, input, scene, surfaces.slots(), visible, scenePass.sample(),
                    input.lineScale * scale, done);
  }
  if (show) addShow();
  work.add(1, [this](int, int) { ++done; });
}

void Viewport::Parts::addShow() {
  addFramebuffer(work, nextPicture, size, {TexelFormat::rgba8}, false, true);
  const Bands bands(size);
  work.add(bands.count(), [this, bands](int from, int to) {
    nextPicture.bind();
    scenePass.light().bind(lightUnit);
    if (!overlayPass.empty()) overlayPass.result().bind(overlayUnit);
    resolve.use();
    resolve.set("hasOverlay", overlayPass.empty() ? 0 : 1);
    bands.draw(from, to, drawFullScreen);
  });
  work.add(1, [this](int, int) {
    std::swap(picture, nextPicture);
    shown = input;
  });
}

void Viewport::Parts::drawFor(int end, double milliseconds) {
  const bool hurry = milliseconds < Piecework::noHurry;
  double left = milliseconds;
  do {
    if (work.empty()) addSample(hurry || done + 1 == end);
    const int before = done;
    const double took = work.drawSome(std::max(left, 0.0));
    left -= took;
    spent += took;
    if (hurry && done > before) cost = SampleCost{scale, spent};
  } while (done < end && left > 0);
}

Viewport::Viewport() : parts_(std::make_unique<Parts>()) {
  checkGl("preparing the 3D view");
}

Viewport::~Viewport() = default;

bool Viewport::draw(const ViewportInput& input, double scale, int samplesNow, int samples,
                    double milliseconds) {
  CHECK(input.width > 0 && input.height > 0 && scale > 0 && scale <= 1 && samplesNow > 0 && samples > 0);
  Parts& p = *parts_;
  const SavedTarget saved;
  p.asked = samples;
  const bool changed = p.scale != scale || !(p.input == input);
  p.behind = changed && milliseconds < Piecework::noHurry && p.mustFinish();
  if (!changed && p.done >= samples) return false;
  if (milliseconds < Piecework::noHurry) glFinish();  // what others have asked for is not measured
  resetStates();
  glBindVertexArray(p.noVertices);
  const auto start = std::chrono::steady_clock::now();
  if (changed && !p.behind) p.begin(input, scale);
  milliseconds -= std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  p.block.bind();
  p.surfaces.bind();
  p.drawFor(p.behind ? p.done + 1 : std::min(p.done + samplesNow, samples), milliseconds);
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
  return true;
}

bool Viewport::complete() const {
  return parts_->scale > 0 && !parts_->behind && parts_->done >= parts_->asked;
}

double Viewport::fraction() const {
  const double begun = parts_->work.empty() ? 0 : parts_->work.fraction();
  return std::min(1.0, (parts_->done + begun) / parts_->asked);
}

bool Viewport::current() const {
  return parts_->scale > 0 && !parts_->behind && parts_->shown == parts_->input;
}

std::optional<Viewport::SampleCost> Viewport::takeCost() {
  return std::exchange(parts_->cost, std::nullopt);
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
