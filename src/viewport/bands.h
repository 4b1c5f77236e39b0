// What piecework.h draws piece by piece: the pixels of a rectangle, and long lists.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include "gl/framebuffer.h"
#include "viewport/piecework.h"

namespace anamorph {

struct PixelSize {
  int width = 0, height = 0;
  bool operator==(const PixelSize&) const = default;
};

/// Pixels from the lower left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelRect&) const = default;
};

/// For a pass over all pixels of a rectangle. Pieces that follow each other lie far apart: so any few of them take
/// about as long as any other few, and threads of a driver that share pixels out by their place all have some.
class Bands {
 public:
  explicit Bands(const PixelRect& area);
  /// The whole picture.
  explicit Bands(const PixelSize& size) : Bands(PixelRect{0, 0, size.width, size.height}) {}

  int count() const { return columns_ * rows_; }
  /// Piece `i` of count(); together they cover the area once.
  PixelRect at(int i) const;
  /// Calls `draw` with OpenGL's scissor around each of the pieces [from, to), once for all of them.
  void draw(int from, int to, const std::function<void()>& draw) const;

 private:
  PixelRect area_;
  int columns_, rows_, stride_;
};

/// Makes `target` anew where it is not of this size; a piece of its own, as it may be large.
void addFramebuffer(Piecework& work, Framebuffer& target, const PixelSize& size,
                    std::vector<TexelFormat> formats, bool withDepth, bool smooth = false);

/// One triangle over the whole picture, by the program in use (shaders/full_screen.vert.glsl).
void drawFullScreen();

/// Things in a row, `each` of them a piece.
struct ListPieces {
  int length = 0, each = 1;

  int count() const { return (length + each - 1) / each; }
  /// The first thing of a piece; where the last one ends for count().
  int begin(int piece) const { return std::min(piece * each, length); }
};

/// The pieces of a mesh's triangles, and OpenGL's call for some of them.
ListPieces trianglePieces(int triangles);
void drawTriangles(const ListPieces& triangles, int from, int to);

}  // namespace anamorph
