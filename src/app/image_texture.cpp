#include "app/image_texture.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace anamorph {
namespace {

std::vector<std::uint8_t> rgbaOf(const Bitmap& bitmap, int fromRow, int toRow) {
  const std::size_t first = static_cast<std::size_t>(fromRow) * bitmap.width,
                    pixels = static_cast<std::size_t>(toRow - fromRow) * bitmap.width;
  const std::size_t channels = static_cast<std::size_t>(bitmap.channels);
  std::vector<std::uint8_t> rgba(4 * pixels, 255);
  for (std::size_t i = 0; i < pixels; ++i) {
    for (std::size_t c = 0; c < channels; ++c) rgba[4 * i + c] = bitmap.bytes[channels * (first + i) + c];
  }
  return rgba;
}

}  // namespace

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
  texture_ = Texture(TexelFormat::rgba8, bitmap.width, bitmap.height, smooth);
  texture_.write(0, 0, bitmap.width, bitmap.height, rgbaOf(bitmap, 0, bitmap.height).data());
}

void ImageTexture::show(const std::shared_ptr<const Bitmap>& bitmap) {
  if (bitmap != bitmap_) {
    bitmap_ = bitmap;
    rows_ = 0;
    coming_ = bitmap ? Texture(TexelFormat::rgba8, bitmap->width, bitmap->height, true) : Texture();
  }
  if (coming_.empty()) return;
  constexpr int pixelsInCall = 1 << 21;
  const int end = std::min(bitmap->height, rows_ + std::max(1, pixelsInCall / bitmap->width));
  coming_.write(0, rows_, bitmap->width, end - rows_, rgbaOf(*bitmap, rows_, end).data());
  rows_ = end;
  if (rows_ == bitmap->height) texture_ = std::exchange(coming_, Texture());
}

UiTexture ImageTexture::texture() const {
  return {texture_.name(), texture_.width(), texture_.height(), false};
}

}  // namespace anamorph
