#include "raytrace/png.h"

#include <fmt/format.h>

#include "base/check.h"
#include "base/error.h"
#include "base/file.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>

namespace anamorph {
namespace {

constexpr std::size_t maxBytes = std::size_t{1} << 30;  // stb counts bytes in an int

void append(void* text, void* data, int size) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

}  // namespace

std::string encodePng(const Bitmap& bitmap) {
  const auto& [width, height, channels, bytes] = bitmap;
  CHECK(width > 0 && height > 0 && (channels == 3 || channels == 4));
  CHECK(bytes.size() == static_cast<std::size_t>(width) * height * channels);
  if (bytes.size() > maxBytes - height) {
    throw Error(
        fmt::format("expected a picture of at most {} bytes, got {} x {} pixels", maxBytes, width, height));
  }
  std::string png;
  const int done =
      stbi_write_png_to_func(append, &png, width, height, channels, bytes.data(), width * channels);
  if (done == 0) throw Error("not enough memory to encode the picture");
  return png;
}

std::vector<std::string> savePng(const std::filesystem::path& path, const Bitmap& bitmap) {
  return writeFile(path, encodePng(bitmap));
}

std::vector<std::string> savePng(const std::filesystem::path& path, const Image& image) {
  return savePng(path, toBitmap(image));
}

Bitmap loadPng(const std::filesystem::path& path) {
  const FileBytes file = readFile(path, maxBytes);
  const auto* data = reinterpret_cast<const stbi_uc*>(file.data.get());
  Bitmap bitmap;
  int stored = 0;
  const bool known =
      stbi_info_from_memory(data, static_cast<int>(file.size), &bitmap.width, &bitmap.height, &stored);
  bitmap.channels = stored == 2 || stored == 4 ? 4 : 3;
  stbi_uc* pixels = known ? stbi_load_from_memory(data, static_cast<int>(file.size), &bitmap.width,
                                                  &bitmap.height, &stored, bitmap.channels)
                          : nullptr;
  if (!pixels)
    throw Error(fmt::format("expected a PNG picture, got {}", stbi_failure_reason()), path.string());
  const std::size_t size = static_cast<std::size_t>(bitmap.width) * bitmap.height * bitmap.channels;
  bitmap.bytes.assign(pixels, pixels + size);
  stbi_image_free(pixels);
  return bitmap;
}

}  // namespace anamorph
