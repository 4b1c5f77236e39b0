// Pictures from the processor on the graphics card, for the panels. Uploaded again only when the pointer
// changed.
#pragma once

#include <memory>

#include "gl/texture.h"
#include "panels/textures.h"
#include "raytrace/image.h"

namespace anamorph {

class ImageTexture {
 public:
  /// Shows linear light as a display wants it. Null: nothing.
  void show(const std::shared_ptr<const Image>& image, bool smooth);
  /// The same for a finished bitmap of 3 or 4 channels. Of a large one a call uploads a part; until all is there, the
  /// last one is shown.
  void show(const std::shared_ptr<const Bitmap>& bitmap);
  void show(const Bitmap& bitmap, bool smooth);

  /// Whether all is there.
  bool complete() const { return coming_.empty(); }

  UiTexture texture() const;

 private:
  std::shared_ptr<const Image> image_;
  bool smooth_ = false;
  std::shared_ptr<const Bitmap> bitmap_;
  Texture texture_, coming_;  // the second with the rows of bitmap_ above rows_
  int rows_ = 0;
};

}  // namespace anamorph
