#include "viewport/overlay_pass.h"

#include <glad/gl.h>

#include "viewport/scene_program.h"

namespace anamorph {
namespace {

constexpr int depthUnit = 4;
constexpr double dotRadius = 2.2;  // pixels at 100 %

void beginInk(const Framebuffer& target) {
  target.bind();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace

OverlayPass::OverlayPass() : dots_(makeSceneProgram("dot.vert.glsl", "dot.frag.glsl")) {
  dots_.use();
  dots_.set("depth", depthUnit);
}

void OverlayPass::update(const ViewportInput& input, const SurfaceSlots& slots, const Visible& visible,
                         const Point& origin, const PixelSize& size) {
  origin_ = origin;
  lines_.update(input.lines, origin);
  hasOutline_ = OutlinePass::wanted(input, visible);
  hasDots_ = input.display.statusColors && visible.sculpture && !slots[0].whole;
  anything_ = lines_.count() > 0 || hasOutline_ || hasDots_;
  mean_.resize(size);
}

void OverlayPass::add(Piecework& work, const ViewportInput& input, const SceneBlock& scene,
                      const SurfaceSlots& slots, const Visible& visible, const Framebuffer& lit,
                      double pixelScale, int number) {
  mean_.addBegin(work, number);
  work.add(1, [this](int, int) {
    mean_.sample().bind();
    const GLfloat nothing[] = {0, 0, 0, 0};
    glClearBufferfv(GL_COLOR, 0, nothing);
  });
  if (hasDots_ && slots[0].triangles > 0) {
    addDots(work, lit, pixelScale, static_cast<int>(input.sculpture.prepared.mesh->positions.size()));
  }
  if (hasOutline_) outline_.add(work, mean_.sample(), input, scene, origin_, slots, visible, pixelScale);
  addLines(work, lit, pixelScale);
  mean_.addEnd(work, number);
}

void OverlayPass::addDots(Piecework& work, const Framebuffer& lit, double pixelScale, int vertices) {
  const ListPieces dots{vertices, 2048};
  work.add(dots.count(), [this, &lit, pixelScale, dots](int from, int to) {
    beginInk(mean_.sample());
    lit.color(1).bind(depthUnit);
    dots_.use();
    dots_.set("radius", static_cast<float>(dotRadius * pixelScale));
    dots_.set("first", dots.begin(from));
    glDrawArraysInstanced(GL_TRIANGLES, 0, 6, dots.begin(to) - dots.begin(from));
    glDisable(GL_BLEND);
  });
}

void OverlayPass::addLines(Piecework& work, const Framebuffer& lit, double pixelScale) {
  const ListPieces lines{lines_.count(), 32};
  work.add(lines.count(), [this, &lit, pixelScale, lines](int from, int to) {
    beginInk(mean_.sample());
    lines_.draw(lit.color(1), pixelScale, lines.begin(from), lines.begin(to));
    glDisable(GL_BLEND);
  });
}

}  // namespace anamorph
