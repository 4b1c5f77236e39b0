#include "viewport/overlay_pass.h"

#include <glad/gl.h>

#include "viewport/scene_program.h"

namespace anamorph {
namespace {

constexpr int depthUnit = 4;
constexpr double dotRadius = 2.2;  // pixels at 100 %

}  // namespace

OverlayPass::OverlayPass() : dots_(makeSceneProgram("dot.vert.glsl", "dot.frag.glsl")) {
  dots_.use();
  dots_.set("depth", depthUnit);
}

void OverlayPass::update(const ViewportInput& input, const SurfaceSlots& slots, const Visible& visible,
                         const Point& origin, int width, int height) {
  origin_ = origin;
  lines_.update(input.lines, origin);
  hasOutline_ = OutlinePass::wanted(input, visible);
  hasDots_ = input.display.statusColors && visible.sculpture && !slots[0].whole;
  anything_ = !lines_.empty() || hasOutline_ || hasDots_;
  if (anything_) mean_.resize(width, height, {TexelFormat::rgba8}, false);
}

void OverlayPass::draw(const ViewportInput& input, const SceneBlock& scene, const SurfaceSlots& slots,
                       const Visible& visible, const Texture& depth, double pixelScale, int number) {
  mean_.beginSample(number);
  mean_.sample().bind();
  const GLfloat nothing[] = {0, 0, 0, 0};
  glClearBufferfv(GL_COLOR, 0, nothing);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  if (hasDots_) {
    drawDots(slots, depth, pixelScale, static_cast<int>(input.sculpture.prepared.mesh->positions.size()));
  }
  if (hasOutline_) outline_.draw(mean_.sample(), input, scene, origin_, slots, visible, pixelScale);
  lines_.draw(depth, pixelScale);
  glDisable(GL_BLEND);
  mean_.endSample(number);
}

void OverlayPass::drawDots(const SurfaceSlots& slots, const Texture& depth, double pixelScale, int vertices) {
  if (slots[0].triangles == 0) return;
  depth.bind(depthUnit);
  dots_.use();
  dots_.set("radius", static_cast<float>(dotRadius * pixelScale));
  glDrawArraysInstanced(GL_TRIANGLES, 0, 6, vertices);
}

}  // namespace anamorph
