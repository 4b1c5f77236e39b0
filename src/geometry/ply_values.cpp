#include "geometry/ply_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/file_text.h"
#include "geometry/little_endian_file.h"

namespace anamorph {
namespace {

double decode(PlyType type, const char* bytes) {
  switch (type) {
    case PlyType::int8:
      return readLittleEndian<std::int8_t>(bytes);
    case PlyType::uint8:
      return readLittleEndian<std::uint8_t>(bytes);
    case PlyType::int16:
      return readLittleEndian<std::int16_t>(bytes);
    case PlyType::uint16:
      return readLittleEndian<std::uint16_t>(bytes);
    case PlyType::int32:
      return readLittleEndian<std::int32_t>(bytes);
    case PlyType::uint32:
      return readLittleEndian<std::uint32_t>(bytes);
    case PlyType::float32:
      return readLittleEndian<float>(bytes);
    case PlyType::float64:
      break;
  }
  return readLittleEndian<double>(bytes);
}

}  // namespace

std::optional<double> PlyValues::next(PlyType type) {
  if (format_ != PlyFormat::ascii) return nextBinary(type);
  word_ = takeWord(rest_);
  return parseNumber(word_);
}

std::optional<double> PlyValues::nextBinary(PlyType type) {
  const std::size_t size = sizeOf(type);
  if (rest_.size() < size) {
    rest_ = {};
    return std::nullopt;
  }
  std::array<char, 8> bytes{};
  std::copy_n(rest_.data(), size, bytes.data());
  rest_.remove_prefix(size);
  if (format_ == PlyFormat::binaryBigEndian)
    std::reverse(bytes.begin(), bytes.begin() + static_cast<int>(size));
  return decode(type, bytes.data());
}

bool PlyValues::skip(PlyType type, std::size_t count) {
  if (format_ != PlyFormat::ascii) {
    const bool enough = count <= rest_.size() / sizeOf(type);
    rest_.remove_prefix(enough ? count * sizeOf(type) : rest_.size());
    return enough;
  }
  for (; count > 0; --count) {
    word_ = takeWord(rest_);
    if (word_.empty()) return false;
  }
  return true;
}

std::size_t PlyValues::mostRows(const PlyElement& element) const {
  const bool isText = format_ == PlyFormat::ascii;
  std::size_t rowSize = 0;  // with empty lists
  for (const PlyProperty& property : element.properties) {
    rowSize += isText ? 2 : sizeOf(property.countType.value_or(property.type));  // a digit and a blank
  }
  if (rowSize == 0) return std::numeric_limits<std::size_t>::max();
  return (rest_.size() + (isText ? 1 : 0)) / rowSize;
}

std::string PlyValues::lastValue() const {
  return inQuotesOrEnd(word_);
}

}  // namespace anamorph
