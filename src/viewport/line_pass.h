// Draws lines into the ink of a picture: antialiased, dashed and dotted in pixels, with arrow heads, faint
// where something is before them.
#pragma once

#include <memory>
#include <vector>

#include "gl/shader.h"
#include "gl/texture.h"
#include "viewport/line.h"

namespace anamorph {

class LinePass {
 public:
  LinePass();

  /// Uploads the lines when they or the origin have changed. Null: none.
  void update(const std::shared_ptr<const std::vector<Line>>& lines, const Point& origin);
  int count() const { return count_; }

  /// Lines [from, to) of count(), into the current framebuffer, over what is there. `depth`: shaders/camera.glsl,
  /// lineDepth(). `pixelScale`: pixels for one of a line's width.
  void draw(const Texture& depth, double pixelScale, int from, int to);

 private:
  ShaderProgram program_;
  TexelArrays texels_;
  std::shared_ptr<const std::vector<Line>> lines_;
  Point origin_{0};
  int count_ = 0;
};

}  // namespace anamorph
