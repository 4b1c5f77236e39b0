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
  /// The same for a finished bitmap of 3 or 4 channels.
  void show(const Bitmap& bitmap, bool smooth);

  UiTexture texture() const;

 private:
  std::shared_ptr<const Image> image_;
  bool smooth_ = false;
  Texture texture_;
};

}  // namespace anamorph
