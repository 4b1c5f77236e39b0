// What a pixel of the compared picture shows (match.h).
#pragma once

#include <cstdint>

namespace anamorph {

enum class PixelClass : std::uint8_t {
  background,      ///< neither
  both,            ///< original and reflection agree that something is there
  onlyOriginal,    ///< the reflection lacks it
  onlyReflection,  ///< the reflection has it, the original does not
  hidden,          ///< the original is here, but sculpture, floor or obstacle stands in the way
  missed,          ///< the original is here, but there is no mirror
};

/// Whether the original is seen there.
constexpr bool showsOriginal(PixelClass kind) {
  return kind != PixelClass::background && kind != PixelClass::onlyReflection;
}

/// Whether the reflection is seen there.
constexpr bool showsReflection(PixelClass kind) {
  return kind == PixelClass::both || kind == PixelClass::onlyReflection;
}

}  // namespace anamorph
