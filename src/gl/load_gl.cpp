#include "gl/load_gl.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include <glad/gl.h>

#include "base/error.h"

namespace anamorph {
namespace {

std::string textOf(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "unknown";
}

}  // namespace

void loadGl(GlGetter getter) {
  const int version = gladLoadGL(getter);
  if (version == 0) throw Error("no OpenGL functions were found; is a graphics driver installed?");
  if (version < GLAD_MAKE_VERSION(3, 3)) {
    throw Error("OpenGL 3.3 is needed, found " + textOf(GL_VERSION) + " (" + textOf(GL_RENDERER) +
                "); a newer graphics driver may help, or software rendering with LIBGL_ALWAYS_SOFTWARE=1");
  }
}

void loadGlEs(GlGetter getter) {
  // glad knows desktop versions only and takes "OpenGL ES 3.x" for 3.x; a 3.2 would do, so its answer is not
  // looked at.
  gladLoadGL(getter);
  if (!glad_glCreateShader || !glad_glGetString) throw Error("no OpenGL ES functions were found");
}

std::string rendererName() {
  return textOf(GL_RENDERER);
}

bool isSoftwareRenderer() {
  std::string name = rendererName();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const char* software : {"llvmpipe", "softpipe", "swiftshader", "swrast", "software"}) {
    if (name.find(software) != std::string::npos) return true;
  }
  return false;
}

}  // namespace anamorph
