// What piecework.h draws piece by piece: the pixels of a rectangle, and long lists.
#pragma once

#include <algorithm>
#include <functional>

namespace anamorph {

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

  int count() const { return columns_ * rows_; }
  /// Piece `i` of count(); together they cover the area once.
  PixelRect at(int i) const;
  /// Calls `draw` with OpenGL's scissor around each of the pieces [from, to), once for all of them.
  void draw(int from, int to, const std::function<void()>& draw) const;

 private:
  PixelRect area_;
  int columns_, rows_, stride_;
};

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
