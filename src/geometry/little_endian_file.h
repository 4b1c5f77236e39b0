// Numbers as STL and PLY store them: little-endian bytes without alignment. Byte by byte, so that it is right
// on every machine; compilers make one load or store of it.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

namespace anamorph {

template <std::size_t size>
using UnsignedOf =
    std::conditional_t<size == 1, std::uint8_t,
                       std::conditional_t<size == 2, std::uint16_t,
                                          std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

/// The number at `bytes`, which must hold sizeof(Number) of them.
template <typename Number>
Number readLittleEndian(const char* bytes) {
  UnsignedOf<sizeof(Number)> bits = 0;
  for (std::size_t i = sizeof(Number); i-- > 0;) {
    bits = static_cast<UnsignedOf<sizeof(Number)>>(std::uint64_t{bits} << 8 |
                                                   static_cast<unsigned char>(bytes[i]));
  }
  return std::bit_cast<Number>(bits);
}

/// Appends sizeof(Number) bytes.
template <typename Number>
void appendLittleEndian(std::string& bytes, Number number) {
  const auto bits = std::bit_cast<UnsignedOf<sizeof(Number)>>(number);
  std::array<char, sizeof(Number)> parts;
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] = static_cast<char>(std::uint64_t{bits} >> (8 * i) & 0xFF);
  bytes.append(parts.data(), parts.size());
}

}  // namespace anamorph
