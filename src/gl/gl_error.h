// What OpenGL complains about, collected where it costs nothing: at the end of a picture, or in a test.
#pragma once

#include <string>

namespace anamorph {

/// The names of all errors since the last call, "GL_INVALID_ENUM, GL_INVALID_VALUE"; empty when there were
/// none.
std::string takeGlErrors();

/// "0x1234", as the manuals write OpenGL's and EGL's numbers.
std::string hexadecimal(unsigned number);

/// Throws Error "`where`: OpenGL reports ..." when there were errors.
void checkGl(const char* where);

}  // namespace anamorph
