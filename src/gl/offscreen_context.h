// OpenGL without a window and without a display server: for screenshots from the command line and for tests.
// Through EGL; all drawing goes into framebuffers of our own, there is no default one.
#pragma once

#include <memory>

#include "gl/load_gl.h"

namespace anamorph {

enum class GlKind {
  desktop,  ///< OpenGL 3.3 core
  es,       ///< OpenGL ES 3.0, what WebGL 2 offers
};

class OffscreenContext {
 public:
  /// OpenGL's functions are of the whole process: a second thread finds them loaded, and may not do it again.
  enum class Functions { load, loaded };

  /// Makes a context, makes it current in this thread and loads OpenGL's functions. Tried in this order:
  /// Mesa's surfaceless platform, EGL devices, the default display. Throws Error that tells what each of them
  /// said, and std::bad_alloc where a software renderer would run out of memory.
  explicit OffscreenContext(GlKind kind = GlKind::desktop, Functions functions = Functions::load);
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  /// After another context was current in this thread.
  void makeCurrent();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  GlKind kind_;
  Functions functions_;
};

}  // namespace anamorph
