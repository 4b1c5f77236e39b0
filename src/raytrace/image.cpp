#include "raytrace/image.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/check.h"

namespace anamorph {
namespace {

constexpr float shoulderStart = 0.75f;

float shoulder(float x) {
  constexpr float room = 1 - shoulderStart;
  return x <= shoulderStart ? x : shoulderStart + room * (1 - std::exp(-(x - shoulderStart) / room));
}

// Light of this strength comes out of the shoulder as `y` < 1.
double beforeShoulder(double y) {
  constexpr double room = 1 - shoulderStart;
  return y <= shoulderStart ? y : shoulderStart - room * std::log(1 - (y - shoulderStart) / room);
}

}  // namespace

Image::Image(int imageWidth, int imageHeight) : width(imageWidth), height(imageHeight) {
  CHECK(width >= 0 && height >= 0);
  pixels.resize(static_cast<std::size_t>(width) * height);
}

float toDisplay(float linear) {
  if (!(linear > 0)) return 0;
  const float x = shoulder(linear);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

glm::vec3 lightShownAs(Rgb color) {
  constexpr double most = 0.999;  // rounds to 0xFF
  const Color light = lightOf(color);
  glm::vec3 before(0);
  for (int c = 0; c < 3; ++c) before[c] = static_cast<float>(beforeShoulder(std::min(light[c], most)));
  return before;
}

Bitmap toBitmap(const Image& image) {
  Bitmap bitmap{image.width, image.height, 3, {}};
  bitmap.bytes.reserve(image.pixels.size() * 3);
  for (const glm::vec3& pixel : image.pixels) {
    for (int c = 0; c < 3; ++c) {
      bitmap.bytes.push_back(static_cast<std::uint8_t>(std::lround(255 * toDisplay(pixel[c]))));
    }
  }
  return bitmap;
}

BitmapDifference compare(const Bitmap& a, const Bitmap& b, int threshold) {
  CHECK(a.width == b.width && a.height == b.height && a.channels == b.channels);
  CHECK(a.bytes.size() == b.bytes.size());
  BitmapDifference result;
  double sum = 0;
  std::size_t over = 0;
  const std::size_t pixels = a.bytes.size() / a.channels;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    int largest = 0;
    for (std::size_t i = pixel * a.channels; i < (pixel + 1) * a.channels; ++i) {
      const int difference = std::abs(int{a.bytes[i]} - int{b.bytes[i]});
      sum += difference;
      largest = std::max(largest, difference);
    }
    result.maxAbsolute = std::max(result.maxAbsolute, largest);
    over += largest > threshold;
  }
  if (pixels > 0) {
    result.meanAbsolute = sum / static_cast<double>(a.bytes.size());
    result.fractionOver = static_cast<double>(over) / static_cast<double>(pixels);
  }
  return result;
}

}  // namespace anamorph
