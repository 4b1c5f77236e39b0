#include "gl/texture.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glad/gl.h>

#include "base/check.h"

namespace anamorph {
namespace {

struct FormatNames {
  GLint internal;
  GLenum format, type;
};

FormatNames namesOf(TexelFormat format) {
  switch (format) {
    case TexelFormat::rgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
    case TexelFormat::r8:
      return {GL_R8, GL_RED, GL_UNSIGNED_BYTE};
    case TexelFormat::rgba16f:
      return {GL_RGBA16F, GL_RGBA, GL_FLOAT};
    case TexelFormat::rgba32f:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
    case TexelFormat::r32f:
      return {GL_R32F, GL_RED, GL_FLOAT};
    case TexelFormat::rgba32ui:
      return {GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT};
    case TexelFormat::r32ui:
      return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
    case TexelFormat::depth:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
  }
  return {};
}

/// Textures are made and written at a unit that no pass reads, so that what is bound for a pass stays.
void bindForWriting(GLuint name) {
  constexpr GLenum scratchUnit = 15;
  glActiveTexture(GL_TEXTURE0 + scratchUnit);
  glBindTexture(GL_TEXTURE_2D, name);
}

// Mesa's software renderer compiles every shader anew where the height of a texture is a power of two and was none
// before, or the other way round. Arrays grow and shrink, so it never is one.
int rowsToMake(int rows) {
  if (rows >= Texture::maxSize()) return rows;
  rows = std::max(rows, 3);
  return std::has_single_bit(static_cast<unsigned>(rows)) ? rows + 1 : rows;
}

int rowsFor(std::size_t length) {
  return static_cast<int>((length + TexelArrays::rowLength - 1) / TexelArrays::rowLength);
}

}  // namespace

Texture::Texture(TexelFormat format, int width, int height, bool smooth)
    : format_(format), width_(width), height_(height) {
  CHECK(width > 0 && height > 0 && width <= maxSize() && height <= maxSize());
  const FormatNames names = namesOf(format);
  glGenTextures(1, &name_);
  bindForWriting(name_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, names.internal, width, height, 0, names.format, names.type, nullptr);
}

Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

Texture::Texture(Texture&& other) noexcept {
  *this = std::move(other);
}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(format_, other.format_);
  std::swap(name_, other.name_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  return *this;
}

void Texture::write(int x, int y, int width, int height, const void* texels) {
  const FormatNames names = namesOf(format_);
  bindForWriting(name_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, names.format, names.type, texels);
}

void Texture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, name_);
}

int Texture::maxSize() {
  GLint size = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &size);
  return size;
}

bool TexelArrays::fits(std::span<const std::size_t> lengths) {
  const std::size_t maxRows = Texture::maxSize();
  std::size_t rows = 0;
  for (const std::size_t length : lengths) {
    if (length > maxRows * rowLength) return false;
    rows += rowsFor(length);
  }
  return rows <= maxRows;
}

bool TexelArrays::reserve(std::span<const std::size_t> lengths) {
  CHECK(lengths.size() == parts_.size());
  const auto hasRoom = [](const Rows& part, std::size_t length) { return rowsFor(length) <= part.rows; };
  if (rows_ > 0 && std::equal(parts_.begin(), parts_.end(), lengths.begin(), hasRoom)) return false;
  int row = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    parts_[i] = {row, rowsFor(lengths[i])};
    row += parts_[i].rows;
  }
  rows_ = rowsToMake(row);
  return true;
}

void TexelArrays::make() {
  texture_ = Texture();  // before a new one, which may be large
  texture_ = Texture(format_, rowLength, rows_);
}

void TexelArrays::write(std::size_t part, std::size_t from, const void* texels, std::size_t count) {
  const Rows& place = parts_[part];
  CHECK(from % rowLength == 0 && rowsFor(from + count) <= place.rows);
  const int row = place.firstRow + static_cast<int>(from / rowLength);
  const int whole = static_cast<int>(count / rowLength), rest = static_cast<int>(count % rowLength);
  const std::size_t texelBytes = 16;  // only formats of four 32-bit numbers are used for arrays
  if (whole > 0) texture_.write(0, row, rowLength, whole, texels);
  if (rest > 0) {
    const auto* last = static_cast<const char*>(texels) + texelBytes * rowLength * whole;
    texture_.write(0, row + whole, rest, 1, last);
  }
}

}  // namespace anamorph
