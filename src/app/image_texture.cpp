#include "app/image_texture.h"

#include <vector>

namespace anamorph {

void ImageTexture::show(const std::shared_ptr<const Image>& image, bool smooth) {
  if (image == image_ && smooth == smooth_) return;
  image_ = image;
  smooth_ = smooth;
  if (image && image->width > 0 && image->height > 0) {
    show(toBitmap(*image), smooth);
  } else {
    texture_ = {};
  }
}

void ImageTexture::show(const Bitmap& bitmap, bool smooth) {
  const std::size_t pixels = static_cast<std::size_t>(bitmap.width) * bitmap.height;
  const std::size_t channels = static_cast<std::size_t>(bitmap.channels);
  std::vector<std::uint8_t> rgba(4 * pixels, 255);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < channels; ++c) rgba[4 * i + c] = bitmap.bytes[channels * i + c];
  }
  texture_ = Texture(TexelFormat::rgba8, bitmap.width, bitmap.height, smooth);
  texture_.write(0, 0, bitmap.width, bitmap.height, rgba.data());
}

UiTexture ImageTexture::texture() const {
  return {texture_.name(), texture_.width(), texture_.height(), false};
}

}  // namespace anamorph
