#include "viewport/bands.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

#include <glad/gl.h>

namespace anamorph {
namespace {

// Drivers that draw in software compute blocks of four by four pixels and share out squares of 64.
constexpr int bandWidth = 256, bandHeight = 8;
constexpr double goldenSection = 0.618;  // multiples of it, without their whole part, spread evenly

int piecesOf(int from, int size, int piece) {
  const int end = from + std::max(size, 0);
  return size <= 0 ? 0 : (end + piece - 1) / piece - from / piece;
}

}  // namespace

Bands::Bands(const PixelRect& area)
    : area_(area),
      columns_(piecesOf(area.x, area.width, bandWidth)),
      rows_(piecesOf(area.y, area.height, bandHeight)),
      stride_(static_cast<int>(goldenSection * count())) {
  while (std::gcd(stride_, count()) > 1) ++stride_;
}

PixelRect Bands::at(int i) const {
  const int place = static_cast<int>(std::int64_t{i} * stride_ % count());
  const int left = (area_.x / bandWidth + place % columns_) * bandWidth,
            low = (area_.y / bandHeight + place / columns_) * bandHeight;
  const int x = std::max(left, area_.x), y = std::max(low, area_.y);
  return {x, y, std::min(left + bandWidth, area_.x + area_.width) - x,
          std::min(low + bandHeight, area_.y + area_.height) - y};
}

void Bands::draw(int from, int to, const std::function<void()>& draw) const {
  glEnable(GL_SCISSOR_TEST);
  const auto drawIn = [&](const PixelRect& rect) {
    glScissor(rect.x, rect.y, rect.width, rect.height);
    draw();
  };
  if (from == 0 && to == count()) {
    drawIn(area_);
  } else {
    for (int i = from; i < to; ++i) drawIn(at(i));
  }
  glDisable(GL_SCISSOR_TEST);
}

void addFramebuffer(Piecework& work, Framebuffer& target, const PixelSize& size,
                    std::vector<TexelFormat> formats, bool withDepth, bool smooth) {
  work.add(1, [&target, size, formats = std::move(formats), withDepth, smooth](int, int) {
    if (target.width() == size.width && target.height() == size.height) return;
    target = Framebuffer();  // before a new one, which is large
    target = Framebuffer(size.width, size.height, formats, withDepth, smooth);
  });
}

void drawFullScreen() {
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

ListPieces trianglePieces(int triangles) {
  return {triangles, 4096};
}

void drawTriangles(const ListPieces& triangles, int from, int to) {
  glDrawArrays(GL_TRIANGLES, 3 * triangles.begin(from), 3 * (triangles.begin(to) - triangles.begin(from)));
}

}  // namespace anamorph
