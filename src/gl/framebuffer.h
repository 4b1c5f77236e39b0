// Where a pass draws: textures instead of the screen. They belong to the framebuffer.
#pragma once

#include <cstdint>
#include <vector>

#include "gl/texture.h"

namespace anamorph {

class Framebuffer {
 public:
  Framebuffer() = default;
  /// One colour texture a format; `withDepth` adds a depth texture. Throws Error when the driver cannot draw
  /// into such formats. `smooth` filters the colours when they are read.
  Framebuffer(int width, int height, const std::vector<TexelFormat>& colors, bool withDepth = false,
              bool smooth = false);
  ~Framebuffer();
  Framebuffer(Framebuffer&& other) noexcept;
  Framebuffer& operator=(Framebuffer&& other) noexcept;

  /// Draws into it from now on, over its whole size.
  void bind() const;

  /// The first colour texture as bytes, RGBA, the first row at the top.
  std::vector<std::uint8_t> readPixels() const;

  const Texture& color(std::size_t i = 0) const { return colors_[i]; }
  const Texture& depth() const { return depth_; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool empty() const { return name_ == 0; }
  std::uint32_t name() const { return name_; }

 private:
  std::uint32_t name_ = 0;
  int width_ = 0, height_ = 0;
  std::vector<Texture> colors_;
  Texture depth_;
};

/// Remembers what is drawn into, and over which part of it; goes back to it at the end.
class SavedTarget {
 public:
  SavedTarget();
  ~SavedTarget();
  SavedTarget(const SavedTarget&) = delete;
  SavedTarget& operator=(const SavedTarget&) = delete;

 private:
  int draw_ = 0, read_ = 0, viewport_[4] = {0, 0, 0, 0};
};

}  // namespace anamorph
