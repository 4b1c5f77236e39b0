#include "gl/gl_error.h"

#include <sstream>

#include <glad/gl.h>

#include "base/error.h"

namespace anamorph {
namespace {

std::string errorName(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE:
      return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION:
      return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY:
      return "GL_OUT_OF_MEMORY";
    default:
      return "error " + hexadecimal(error);
  }
}

}  // namespace

std::string hexadecimal(unsigned number) {
  std::ostringstream text;
  text << "0x" << std::hex << number;
  return text.str();
}

std::string takeGlErrors() {
  constexpr int mostErrors = 16;  // a lost context reports without end
  std::string names;
  for (int i = 0; i < mostErrors; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    names += (names.empty() ? "" : ", ") + errorName(error);
  }
  return names;
}

void checkGl(const char* where) {
  const std::string names = takeGlErrors();
  if (!names.empty()) throw Error("OpenGL reports " + names, {}, where);
}

}  // namespace anamorph
