// Pictures. An Image holds linear light, as the tracer computes it; a Bitmap holds the bytes that a screen or
// a PNG file wants. toBitmap() is the only way from one to the other: a tone curve with a soft shoulder, then
// the sRGB curve. Origin top-left, rows from the top. Files are in png.h.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "math/color.h"

namespace anamorph {

struct Image {
  Image() = default;
  /// Black; width and height must be >= 0.
  Image(int imageWidth, int imageHeight);

  glm::vec3& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
  const glm::vec3& at(int x, int y) const { return pixels[static_cast<std::size_t>(y) * width + x]; }
  bool operator==(const Image&) const = default;

  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;  ///< linear RGB
};

struct Bitmap {
  bool operator==(const Bitmap&) const = default;

  int width = 0;
  int height = 0;
  int channels = 3;                 ///< 3: RGB, 4: RGBA
  std::vector<std::uint8_t> bytes;  ///< sRGB, alpha linear
};

/// Linear light to what a display is sent, 0..1: unchanged up to 0.75, then a shoulder that reaches 1 only at
/// infinity so that highlights keep their shape, then the sRGB curve. Negative values and NaN give 0. Shaders
/// use the same formula.
float toDisplay(float linear);

/// The light that toBitmap() shows as exactly this colour; 0xFF, which no light reaches, as nearly that.
glm::vec3 lightShownAs(Rgb color);

/// Every channel through toDisplay(), rounded to 8 bits; RGB.
Bitmap toBitmap(const Image& image);

struct BitmapDifference {
  double meanAbsolute = 0;  ///< over all channels, 0..255
  int maxAbsolute = 0;      ///< of all channels, 0..255
  /// Of pixels of which some channel differs by more than the threshold, 0..1.
  double fractionOver = 0;
};

/// Compares byte by byte. Size and channels must be equal.
BitmapDifference compare(const Bitmap& a, const Bitmap& b, int threshold);

}  // namespace anamorph
