// OpenGL's functions, looked up once a context is current. glad is generated for OpenGL 3.3 core and nothing
// newer, so a program that builds asks for nothing that a 3.3 driver lacks.
#pragma once

#include <string>

namespace anamorph {

/// Finds a function of OpenGL by name; null when the driver lacks it. Both eglGetProcAddress and
/// glfwGetProcAddress are of this kind.
using GlGetter = void (*(*)(const char* name))();

/// Loads all functions for the context that is current. Throws Error, naming version and renderer found, when
/// it is older than OpenGL 3.3.
void loadGl(GlGetter getter);

/// As loadGl(), for a context of OpenGL ES 3.0 (WebGL 2): its functions are a part of those of OpenGL 3.3.
/// The others stay null and must not be called. Only for checking that shaders compile there.
void loadGlEs(GlGetter getter);

/// What the driver calls itself: "llvmpipe (LLVM 15.0.6, 256 bits)".
std::string rendererName();

/// Whether OpenGL is computed by the processor: then pictures should be small and few.
bool isSoftwareRenderer();

}  // namespace anamorph
