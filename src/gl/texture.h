// Textures: the pictures that passes draw into, and long arrays that shaders read texel by texel. No mipmaps;
// nothing is filtered unless asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace anamorph {

/// The formats in use; all exist in OpenGL ES 3.0.
enum class TexelFormat { rgba8, r8, rgba16f, rgba32f, r32f, rgba32ui, r32ui, depth };

/// Owns a 2D texture. Moved, not copied.
class Texture {
 public:
  Texture() = default;
  /// Contents undefined. `smooth` filters between texels.
  Texture(TexelFormat format, int width, int height, bool smooth = false);
  ~Texture();
  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;

  /// Replaces a rectangle by tightly packed texels: 4 bytes, floats or 32-bit numbers each, as the format
  /// says.
  void write(int x, int y, int width, int height, const void* texels);
  void bind(int unit) const;

  std::uint32_t name() const { return name_; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return name_ == 0; }

  static int maxSize();

 private:
  TexelFormat format_ = TexelFormat::rgba8;
  std::uint32_t name_ = 0;
  int width_ = 0, height_ = 0;
};

/// Several arrays of texels in one texture, each beginning on a row of its own. Texel i of the whole lies at
/// (i % rowLength, i / rowLength); shaders/texel.glsl says the same.
class TexelArrays {
 public:
  static constexpr int rowBits = 11, rowLength = 1 << rowBits;

  TexelArrays(TexelFormat format, std::size_t count) : format_(format), parts_(count) {}

  /// Whether arrays of these lengths fit a texture of this driver.
  static bool fits(std::span<const std::size_t> lengths);

  /// Where everything is to lie; must fit. Returns whether it has moved, so that all of it has to be written again.
  bool reserve(std::span<const std::size_t> lengths);
  /// Whether make() has not been called since.
  bool moved() const { return texture_.height() != rows_; }
  /// Makes room for what was reserved. Before anything is written, and to be bound anew.
  void make();
  /// Writes texels [from, from + count) of a part; `from` is the beginning of a row.
  void write(std::size_t part, std::size_t from, const void* texels, std::size_t count);

  /// Index of the part's first texel in the whole.
  int first(std::size_t part) const { return parts_[part].firstRow * rowLength; }
  void bind(int unit) const { texture_.bind(unit); }

 private:
  struct Rows {
    int firstRow = 0, rows = 0;
  };
  TexelFormat format_;
  std::vector<Rows> parts_;
  int rows_ = 0;  // of the texture; 0: nothing is reserved
  Texture texture_;
};

}  // namespace anamorph
