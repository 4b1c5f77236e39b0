// A GUI without a window: an offscreen context, a framebuffer of the size that a window would have, and a
// mouse that is moved by the program. For screenshots, the benchmark and tests.
#pragma once

#include <memory>

#include "app/gui.h"
#include "app/shot_job.h"
#include "gl/framebuffer.h"

namespace anamorph {

/// A current OpenGL context: EGL, else a hidden window where there is a display. Throws Error when neither is
/// to be had. It stays current for the life of the object.
class HeadlessContext {
 public:
  HeadlessContext();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

class HeadlessGui {
 public:
  HeadlessGui(int width, int height, Preferences preferences, int threads = 0);
  ~HeadlessGui();

  Gui& gui() { return *gui_; }
  int width() const { return framebuffer_.width(); }
  int height() const { return framebuffer_.height(); }
  void resize(int width, int height);

  /// One frame; the mouse is where it was put last.
  void frame(double seconds = 1.0 / 60, const ViewQuality* forced = nullptr);
  /// Frames until everything is computed and drawn in the best quality, and nothing moves.
  void settle();

  void moveMouse(float x, float y);
  void pressMouse(int button, bool down);
  void turnWheel(float steps);
  /// With Ctrl or Shift held for the mouse: keys::control, keys::shift.
  void holdModifiers(int modifiers);

  /// What the window would show: RGBA, first row at the top, alpha 255 unless the GUI is transparent.
  Bitmap readBack() const;

 private:
  std::unique_ptr<Gui> gui_;
  Framebuffer framebuffer_;
  ShotJob shotJob_;
};

}  // namespace anamorph
