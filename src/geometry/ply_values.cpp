#include "geometry/ply_values.h"

#include <fmt/format.h>

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

// Comments belong into the head, but stand between the rows of some files.
bool isComment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("comment ") || line.starts_with("obj_info ");
}

std::uint64_t rowsOf(const PlyHeader& header) {
  std::uint64_t rows = 0;
  for (const PlyElement& element : header.elements) {
    if (!element.properties.empty()) rows += element.count;
  }
  return rows;
}

}  // namespace

PlyValues::PlyValues(std::string_view data, const PlyHeader& header) : rest_(data), format_(header.format) {
  if (!isText()) return;
  rest_ = withoutPadding(rest_);
  if (rest_.find('\n') == std::string_view::npos) lineEnd_ = '\r';
  const std::uint64_t lines = countLines(), rows = rowsOf(header);
  rowsAreLines_ = lines >= rows;
  if (rowsAreLines_) spareLines_ = lines - rows;
  skipLineEnds();
}

// Lines with something on them.
std::uint64_t PlyValues::countLines() const {
  std::uint64_t lines = 0;
  for (std::string_view rest = rest_; !rest.empty();) {
    const std::size_t end = std::min(rest.find(lineEnd_), rest.size());
    std::string_view line = rest.substr(0, end);
    while (!line.empty() && isBlank(line[0])) line.remove_prefix(1);
    if (!line.empty() && !isComment(line)) ++lines;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return lines;
}

void PlyValues::skipBlanks() {
  const char* p = rest_.data();
  const char* const end = p + rest_.size();
  while (p != end && isBlank(*p) && *p != lineEnd_) ++p;
  rest_.remove_prefix(static_cast<std::size_t>(p - rest_.data()));
}

// To the next line that has something on it, unless there is something on this one. Whether there is one.
bool PlyValues::skipLineEnds() {
  while (true) {
    skipBlanks();
    const bool atLineEnd = !rest_.empty() && rest_[0] == lineEnd_;
    if (atLineEnd) {
      rest_.remove_prefix(1);
    } else if (isComment(rest_)) {
      rest_.remove_prefix(std::min(rest_.find(lineEnd_), rest_.size()));
    } else {
      return !rest_.empty();
    }
  }
}

std::string_view PlyValues::takeWordOfRow() {
  skipBlanks();
  if (rest_.empty()) return {};
  if (rest_[0] == lineEnd_) {
    if (rowsAreLines_ && spareLines_ == 0) return {};
    if (rowsAreLines_) --spareLines_;
    skipLineEnds();
  }
  return takeWord(rest_);
}

bool PlyValues::endRow() {
  if (!isText()) return true;
  bool complete = true;
  if (rowsAreLines_) {
    skipBlanks();
    complete = rest_.empty() || rest_[0] == lineEnd_;
    if (!complete) rest_.remove_prefix(std::min(rest_.find(lineEnd_), rest_.size()));
  }
  skipLineEnds();
  return complete;
}

std::optional<double> PlyValues::next(PlyType type) {
  if (!isText()) return nextBinary(type);
  word_ = takeWordOfRow();
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
  if (!isText()) {
    const bool enough = count <= rest_.size() / sizeOf(type);
    rest_.remove_prefix(enough ? count * sizeOf(type) : rest_.size());
    return enough;
  }
  for (; count > 0; --count) {
    word_ = takeWordOfRow();
    if (word_.empty()) return false;
  }
  return true;
}

std::size_t PlyValues::mostRows(const PlyElement& element) const {
  if (element.properties.empty()) return std::numeric_limits<std::size_t>::max();
  std::size_t rowSize = 0;  // with empty lists, which a text may leave out
  for (const PlyProperty& property : element.properties) {
    if (!isText()) rowSize += sizeOf(property.countType.value_or(property.type));
    if (isText() && !property.countType) rowSize += 2;  // a digit and a blank
  }
  if (isText()) return (rest_.size() + 1) / std::max<std::size_t>(rowSize, 2);
  return rest_.size() / rowSize;
}

std::string PlyValues::leftOver() const {
  if (isPadding(rest_)) return {};
  const std::uint64_t count = isText() ? countLines() : rest_.size();
  return fmt::format("{} {}{}", count, isText() ? "line" : "byte", count == 1 ? "" : "s");
}

}  // namespace anamorph
