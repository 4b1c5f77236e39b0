#include "gl/framebuffer.h"

#include <algorithm>
#include <string>
#include <utility>

#include <glad/gl.h>

#include "base/error.h"
#include "gl/gl_error.h"

namespace anamorph {

Framebuffer::Framebuffer(int width, int height, const std::vector<TexelFormat>& colors, bool withDepth,
                         bool smooth)
    : width_(width), height_(height) {
  const SavedTarget saved;
  glGenFramebuffers(1, &name_);
  glBindFramebuffer(GL_FRAMEBUFFER, name_);
  std::vector<GLenum> attachments;
  for (const TexelFormat format : colors) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(attachments.size()));
    const Texture& texture = colors_.emplace_back(format, width, height, smooth);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, texture.name(), 0);
  }
  if (withDepth) {
    depth_ = Texture(TexelFormat::depth, width, height);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  }
  glDrawBuffers(static_cast<GLsizei>(attachments.size()), attachments.data());
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    glDeleteFramebuffers(1, &name_);
    throw Error("the graphics driver cannot draw into a framebuffer of " + std::to_string(width) + " x " +
                std::to_string(height) + " pixels (" + hexadecimal(status) + ")");
  }
}

Framebuffer::~Framebuffer() {
  if (name_ != 0) glDeleteFramebuffers(1, &name_);
}

Framebuffer::Framebuffer(Framebuffer&& other) noexcept {
  *this = std::move(other);
}

Framebuffer& Framebuffer::operator=(Framebuffer&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(colors_, other.colors_);
  std::swap(depth_, other.depth_);
  return *this;
}

void Framebuffer::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, name_);
  glViewport(0, 0, width_, height_);
}

std::vector<std::uint8_t> Framebuffer::readPixels() const {
  const std::size_t rowBytes = std::size_t{4} * static_cast<std::size_t>(width_);
  std::vector<std::uint8_t> bytes(rowBytes * static_cast<std::size_t>(height_));
  if (bytes.empty()) return bytes;
  const SavedTarget saved;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, name_);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  // OpenGL's first row is the lowest one.
  std::uint8_t *upper = bytes.data(), *lower = upper + bytes.size() - rowBytes;
  for (; upper < lower; upper += rowBytes, lower -= rowBytes)
    std::swap_ranges(upper, upper + rowBytes, lower);
  return bytes;
}

SavedTarget::SavedTarget() {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
  glGetIntegerv(GL_VIEWPORT, viewport_);
}

SavedTarget::~SavedTarget() {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
  glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
}

}  // namespace anamorph
