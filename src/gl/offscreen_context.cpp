#include "gl/offscreen_context.h"

#include <sys/mman.h>

#include <array>
#include <cstddef>
#include <cstring>
#include <new>
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "base/error.h"
#include "gl/gl_error.h"

namespace anamorph {

struct OffscreenContext::Parts {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

namespace {

// Mesa's software renderer ends the program where it gets no memory, so it is not begun where that is to be foreseen.
void checkMemory() {
  constexpr std::size_t needed = std::size_t{832} << 20;  // measured, for a picture as large as a window
  void* const room = ::mmap(nullptr, needed, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (room == MAP_FAILED) throw std::bad_alloc();
  ::munmap(room, needed);
}

bool clientHas(const char* extension) {
  const char* all = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  return all && std::strstr(all, extension);
}

EGLDisplay platformDisplay(EGLenum platform, void* native) {
  const auto getDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return getDisplay ? getDisplay(platform, native, nullptr) : EGL_NO_DISPLAY;
}

EGLDisplay surfacelessDisplay() {
  return clientHas("EGL_MESA_platform_surfaceless")
             ? platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY)
             : EGL_NO_DISPLAY;
}

/// The first of the EGL devices that can be initialised.
EGLDisplay deviceDisplay() {
  const auto queryDevices =
      reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (!queryDevices || !queryDevices(devices.size(), devices.data(), &count)) return EGL_NO_DISPLAY;
  for (EGLint i = 0; i < count; ++i) {
    const EGLDisplay display = platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i]);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  }
  return EGL_NO_DISPLAY;
}

EGLDisplay defaultDisplay() {
  return eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

EGLContext makeContext(EGLDisplay display, GlKind kind) {
  const bool desktop = kind == GlKind::desktop;
  if (!eglBindAPI(desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API)) return EGL_NO_CONTEXT;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                           desktop ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL_CONTEXT_MINOR_VERSION,
                            desktop ? 3 : 0,
                            desktop ? EGL_CONTEXT_OPENGL_PROFILE_MASK : EGL_NONE,
                            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                            EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

}  // namespace

OffscreenContext::OffscreenContext(GlKind kind, Functions functions)
    : parts_(std::make_unique<Parts>()), kind_(kind), functions_(functions) {
  checkMemory();
  const struct {
    const char* name;
    EGLDisplay (*open)();
  } ways[] = {
      {"surfaceless", surfacelessDisplay}, {"device", deviceDisplay}, {"default display", defaultDisplay}};
  std::string said;
  for (const auto& way : ways) {
    const auto note = [&](const char* step) {
      said += std::string(said.empty() ? "" : "; ") + way.name + ": " + step;
      said += " (" + hexadecimal(static_cast<unsigned>(eglGetError())) + ")";
    };
    const EGLDisplay display = way.open();
    if (display == EGL_NO_DISPLAY) {
      note("not there");
    } else if (!eglInitialize(display, nullptr, nullptr)) {
      note("cannot be initialised");
    } else if (const EGLContext context = makeContext(display, kind); context == EGL_NO_CONTEXT) {
      note("no context");
    } else if (!eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
      note("the context cannot be made current without a window");
      eglDestroyContext(display, context);
    } else {
      parts_->display = display;
      parts_->context = context;
      break;
    }
  }
  if (parts_->context == EGL_NO_CONTEXT) {
    const std::string wanted = kind == GlKind::desktop ? "OpenGL 3.3" : "OpenGL ES 3.0";
    throw Error("no " + wanted + " without a window: " + said);
  }
  makeCurrent();
}

OffscreenContext::~OffscreenContext() {
  // The display stays initialised: other contexts of the process may share it.
  eglMakeCurrent(parts_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(parts_->display, parts_->context);
}

void OffscreenContext::makeCurrent() {
  eglBindAPI(kind_ == GlKind::desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API);
  if (!eglMakeCurrent(parts_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, parts_->context)) {
    throw Error("the OpenGL context cannot be made current (" +
                hexadecimal(static_cast<unsigned>(eglGetError())) + ")");
  }
  if (functions_ == Functions::loaded) return;
  kind_ == GlKind::desktop ? loadGl(eglGetProcAddress) : loadGlEs(eglGetProcAddress);
}

}  // namespace anamorph
