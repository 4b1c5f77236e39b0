// Colours as numbers: Rgb is what a display or a file is sent, 0xRRGGBB with the sRGB curve; a Color is light where
// nothing else is said, and ink where lines and pages are drawn.
#pragma once

#include <cmath>
#include <cstdint>

#include "math/vec.h"

namespace anamorph {

/// 0xRRGGBB, as displayed.
enum class Rgb : std::uint32_t {};

/// 0..255 of red (0), green (1), blue (2).
constexpr int channelOf(Rgb rgb, int channel) {
  return static_cast<int>(static_cast<std::uint32_t>(rgb) >> (16 - 8 * channel) & 255u);
}

/// The same colour as ink, 0..1 each, still as displayed.
constexpr Color inkOf(Rgb rgb) {
  return {channelOf(rgb, 0) / 255.0, channelOf(rgb, 1) / 255.0, channelOf(rgb, 2) / 255.0};
}

/// The sRGB curve, from light to what a display is sent, and back; 0..1.
inline double displayOf(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055;
}
inline double lightOf(double display) {
  return display <= 0.04045 ? display / 12.92 : std::pow((display + 0.055) / 1.055, 2.4);
}

/// The linear light of a colour.
inline Color lightOf(Rgb rgb) {
  const Color ink = inkOf(rgb);
  return {lightOf(ink.x), lightOf(ink.y), lightOf(ink.z)};
}

}  // namespace anamorph
