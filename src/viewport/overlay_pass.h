// What is drawn over the lit scene in colours of the display: lines, dots, outline. Kept apart from the
// light, because a mean of ink must not go through the tone curve.
#pragma once

#include "gl/framebuffer.h"
#include "gl/shader.h"
#include "viewport/line_pass.h"
#include "viewport/outline_pass.h"
#include "viewport/scene_block.h"
#include "viewport/scene_pass.h"

namespace anamorph {

class OverlayPass {
 public:
  OverlayPass();

  /// What there is to draw for this input; the picture's size.
  void update(const ViewportInput& input, const SurfaceSlots& slots, const Visible& visible,
              const Point& origin, const PixelSize& size);
  bool empty() const { return !anything_; }

  /// The work of adding a sample to the mean, as ScenePass::add. `lit` is the same sample of that; `pixelScale`: pixels of
  /// the picture for one of a line's width.
  void add(Piecework& work, const ViewportInput& input, const SceneBlock& scene, const SurfaceSlots& slots,
           const Visible& visible, const Framebuffer& lit, double pixelScale, int number);

  /// The mean: display colour times alpha, alpha. Undefined while empty().
  const Texture& result() const { return mean_.result(); }

 private:
  void addDots(Piecework& work, const Framebuffer& lit, double pixelScale, int vertices);
  void addLines(Piecework& work, const Framebuffer& lit, double pixelScale);

  LinePass lines_;
  OutlinePass outline_;
  ShaderProgram dots_;
  SampleMean mean_{{TexelFormat::rgba8}, false};
  Point origin_{0};
  bool anything_ = false, hasOutline_ = false, hasDots_ = false;
};

}  // namespace anamorph
