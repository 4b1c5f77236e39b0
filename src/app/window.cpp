#include "app/window.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include "app/crash_handler.h"
#include "app/gui.h"
#include "app/key_taps.h"
#include "app/preferences.h"
#include "app/quit.h"
#include "app/shot_job.h"
#include "app/state_folder.h"
#include "app/state_log.h"
#include "app/window_files.h"
#include "base/error.h"
#include "cli/print.h"
#include "edit/lesson_run.h"
#include "edit/session.h"
#include "gl/load_gl.h"
#include "level/limits.h"
#include "panels/actions.h"
#include "panels/file_flow.h"

namespace anamorph {
namespace {

static_assert(keys::escape == GLFW_KEY_ESCAPE && keys::tab == GLFW_KEY_TAB && keys::home == GLFW_KEY_HOME &&
              keys::pageUp == GLFW_KEY_PAGE_UP && keys::pageDown == GLFW_KEY_PAGE_DOWN &&
              keys::f1 == GLFW_KEY_F1 && keys::f12 == GLFW_KEY_F12 && keys::pad0 == GLFW_KEY_KP_0 &&
              keys::space == GLFW_KEY_SPACE && keys::f3 == GLFW_KEY_F3 && keys::f4 == GLFW_KEY_F4 &&
              keys::left == GLFW_KEY_LEFT && keys::right == GLFW_KEY_RIGHT && keys::enter == GLFW_KEY_ENTER &&
              keys::padEnter == GLFW_KEY_KP_ENTER && keys::backspace == GLFW_KEY_BACKSPACE &&
              keys::up == GLFW_KEY_UP && keys::down == GLFW_KEY_DOWN && keys::end == GLFW_KEY_END &&
              keys::shift == GLFW_MOD_SHIFT && keys::control == GLFW_MOD_CONTROL &&
              keys::alt == GLFW_MOD_ALT);

constexpr double livelySeconds = 0.8;  // after an event: tooltips appear, hover colours change
constexpr double livelyStep = 1.0 / 30;
constexpr double playingStep = 1.0 / 30;  // while a clock of the panels runs

std::string lastGlfwError() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

struct GlfwDeleter {
  void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using WindowHandle = std::unique_ptr<GLFWwindow, GlfwDeleter>;

// Begins and ends GLFW.
struct Glfw {
  Glfw() {
    if (!glfwInit()) {
      throw Error(
          "cannot open a window: " + lastGlfwError() +
          ". Without a display, `anamorph screenshot LEVEL -o OUT.png` draws what the window shows, and "
          "`anamorph levels -o FOLDER` renders all levels");
    }
  }
  ~Glfw() { glfwTerminate(); }
  Glfw(const Glfw&) = delete;
  Glfw& operator=(const Glfw&) = delete;
};

// What the machine has instead of OpenGL 3.3.
std::string versionFound() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  const WindowHandle probe(glfwCreateWindow(64, 64, "probe", nullptr, nullptr));
  if (!probe) return "no OpenGL at all";
  glfwMakeContextCurrent(probe.get());
  using GetString = const unsigned char* (*)(unsigned);
  const auto getString = reinterpret_cast<GetString>(glfwGetProcAddress("glGetString"));
  const unsigned char* version = getString ? getString(GL_VERSION) : nullptr;
  return version ? "OpenGL " + std::string(reinterpret_cast<const char*>(version))
                 : "an OpenGL that does not say";
}

WindowHandle makeWindow(const WindowOptions& options) {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  WindowHandle window(glfwCreateWindow(options.width, options.height, "Anamorph", nullptr, nullptr));
  if (!window) {
    const std::string why = lastGlfwError();
    throw Error("Anamorph needs OpenGL 3.3; this machine offers " + versionFound() + " (" + why + ")");
  }
  glfwSetWindowSizeLimits(window.get(), 320, 200, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return window;
}

// Keyboards differ: GLFW names keys by their place on an American one. A letter is the key that has it on its
// cap, so that Ctrl+Z is Ctrl+Z on a German keyboard, too. All other keys are known by their place.
int keyByItsCap(int key, int code) {
  const char* name = glfwGetKeyName(key, code);
  if (!name || name[0] < 'a' || name[0] > 'z' || name[1] != 0) return key;
  return name[0] - 'a' + 'A';
}

class MainWindow {
 public:
  MainWindow(const WindowOptions& options, Preferences preferences)
      : stateLog_(options.stateLog), handle_(makeWindow(options)) {
    glfwMakeContextCurrent(handle_.get());
    loadGl(glfwGetProcAddress);
    glfwSwapInterval(1);
    gui_ = std::make_unique<Gui>(preferences, [] { glfwPostEmptyEvent(); });
    gui_->keepShadersWarm([] { glfwPostEmptyEvent(); });
    shotJob_ = std::make_unique<ShotJob>([] { glfwPostEmptyEvent(); });
    ImGui_ImplGlfw_InitForOpenGL(handle_.get(), false);
    installCallbacks();
    files_ =
        std::make_unique<WindowFiles>(stateFolder(), preferencesPath(), *gui_, [] { glfwPostEmptyEvent(); });
    gui_->open(options.level);
    if (!options.model.empty()) importOriginal(gui_->editor(), options.model);
    start(options);
    if (options.fullscreen) toggleFullscreen();
  }
  ~MainWindow() {
    ImGui_ImplGlfw_Shutdown();
    files_.reset();
    shotJob_.reset();
    gui_.reset();  // while the context lives
  }
  MainWindow(const MainWindow&) = delete;
  MainWindow& operator=(const MainWindow&) = delete;

  void run() {
    while (!glfwWindowShouldClose(handle_.get())) {
      waitForWork();
      int width = 0, height = 0;
      glfwGetFramebufferSize(handle_.get(), &width, &height);
      const bool iconified = glfwGetWindowAttrib(handle_.get(), GLFW_ICONIFIED) != 0;
      // The question about unsaved changes has to be seen.
      if (iconified && gui_->ui().requests.quit) glfwRestoreWindow(handle_.get());
      // Files that are being made go on, and so does the wish to quit that waits for them.
      const bool atWork = gui_->unfinished() || gui_->ui().finish;
      if (width <= 0 || height <= 0 || (iconified && !atWork)) {
        waitUnseen();
        continue;
      }
      drawFrame();
    }
    quit();
  }

 private:
  // What is not written in a moment is told of; whatever still runs or hangs must not keep anybody waiting.
  void quit() {
    glfwHideWindow(handle_.get());
    endProgramIn(0.45);
    reportUnwritten(gui_->unwritten(0.1));
    reportUnwritten(shotJob_->unwritten(0.05));
    reportUnwritten(files_->unwritten(0.15));
  }

  // Nothing is drawn, but what is not saved has to be kept.
  void waitUnseen() {
    const double now = glfwGetTime();
    files_->update(now);
    const auto due = files_->secondsUntilDue(now);
    due ? glfwWaitEventsTimeout(*due + 0.01) : glfwWaitEvents();
  }

  // Events come at once; without any the next frame is drawn when something is unfinished or due.
  void waitForWork() {
    const double now = glfwGetTime();
    if (gui_->unfinished()) {
      const bool onlyWorker = (gui_->viewComplete() || gui_->ui().preparingView) &&
                              !gui_->ui().shot.drawing && !isMoving(gui_->editor()) &&
                              now - lastEvent_ > livelySeconds;
      if (!onlyWorker) return glfwPollEvents();
      return glfwWaitEventsTimeout(gui_->editor().updater.secondsUntilDue().value_or(0.1) + 0.01);
    }
    if (gui_->isPlaying()) return glfwWaitEventsTimeout(playingStep);
    if (framesOwed_ > 0) {
      --framesOwed_;
      return glfwPollEvents();
    }
    if (now - lastEvent_ < livelySeconds) return glfwWaitEventsTimeout(livelyStep);
    if (const auto due = files_->secondsUntilDue(now)) return glfwWaitEventsTimeout(*due + 0.01);
    stateLog_.addRest(*gui_);
    glfwWaitEvents();
  }

  void drawFrame() {
    const double now = glfwGetTime(), seconds = std::clamp(now - lastFrame_, 1e-4, 0.1);
    lastFrame_ = now;
    float scaleX = 1, scaleY = 1;
    glfwGetWindowContentScale(handle_.get(), &scaleX, &scaleY);
    gui_->setScreenScale(std::clamp(std::round(4.0 * scaleX) / 4, limits::uiScale.min, limits::uiScale.max));
    const InputCounts seen = received_;
    ImGui_ImplGlfw_NewFrame();
    gui_->frame(seconds);
    for (const auto& [key, code, modifiers] : keyTaps_.takeReleases()) {
      ImGui_ImplGlfw_KeyCallback(handle_.get(), key, code, GLFW_RELEASE, modifiers);
      ++received_.keysUp;
    }
    glfwSwapBuffers(handle_.get());
    shotJob_->update(*gui_);
    if (files_->update(now)) wakeUp();
    stateLog_.add(*gui_, seen);
    serveRequests();
    showTitle();
  }

  void serveRequests() {
    UiRequests& requests = gui_->ui().requests;
    if (std::exchange(requests.quit, false)) glfwSetWindowShouldClose(handle_.get(), GLFW_TRUE);
    if (std::exchange(requests.toggleFullscreen, false)) toggleFullscreen();
  }

  void start(const WindowOptions& options) {
    Editor& editor = gui_->editor();
    advanceLesson(editor);  // takes the lesson up
    if (options.step > 0) openStep(editor, options.step - 1);
    if (options.present) perform(Action::present, editor, gui_->ui());
    if (options.tour && !options.present && !gui_->ui().preferences.tourSeen) {
      perform(Action::tour, editor, gui_->ui());
    }
  }

  void toggleFullscreen() {
    GLFWwindow* window = handle_.get();
    if (glfwGetWindowMonitor(window)) {
      glfwSetWindowMonitor(window, nullptr, place_[0], place_[1], place_[2], place_[3], GLFW_DONT_CARE);
      return;
    }
    glfwGetWindowPos(window, &place_[0], &place_[1]);
    glfwGetWindowSize(window, &place_[2], &place_[3]);
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }

  void showTitle() {
    const std::string title = windowTitle(gui_->editor().session);
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(handle_.get(), title.c_str());
  }

  void wakeUp() {
    lastEvent_ = glfwGetTime();
    framesOwed_ = 3;  // Dear ImGui lays out in two
  }

  void receive(std::size_t InputCounts::*kind) {
    ++(received_.*kind);
    wakeUp();
  }

  static MainWindow& of(GLFWwindow* window) {
    return *static_cast<MainWindow*>(glfwGetWindowUserPointer(window));
  }

  void installCallbacks() {
    GLFWwindow* window = handle_.get();
    glfwSetWindowUserPointer(window, this);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int code, int action, int modifiers) {
      MainWindow& self = of(w);
      self.wakeUp();
      if (action == GLFW_PRESS) self.keyTaps_.press(key);
      if (action == GLFW_RELEASE && self.keyTaps_.waits({key, code, modifiers})) return;
      if (action != GLFW_REPEAT)
        self.receive(action == GLFW_PRESS ? &InputCounts::keysDown : &InputCounts::keysUp);
      ImGui_ImplGlfw_KeyCallback(w, key, code, action, modifiers);
      if (action == GLFW_PRESS || action == GLFW_REPEAT) {
        self.gui_->key(keyByItsCap(key, code),
                       modifiers & (GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER),
                       action == GLFW_REPEAT);
      }
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int modifiers) {
      ImGui_ImplGlfw_MouseButtonCallback(w, button, action, modifiers);
      of(w).receive(action == GLFW_PRESS ? &InputCounts::buttonsDown : &InputCounts::buttonsUp);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) {
      ImGui_ImplGlfw_ScrollCallback(w, x, y);
      of(w).receive(&InputCounts::wheel);
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned c) {
      ImGui_ImplGlfw_CharCallback(w, c);
      of(w).receive(&InputCounts::characters);
    });
    glfwSetCursorPosCallback(window,
                             [](GLFWwindow* w, double, double) { of(w).receive(&InputCounts::motions); });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
      ImGui_ImplGlfw_CursorEnterCallback(w, entered);
      of(w).wakeUp();
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
      ImGui_ImplGlfw_WindowFocusCallback(w, focused);
      of(w).wakeUp();
    });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
      of(w).gui_->drop({paths, paths + count});
      of(w).wakeUp();
    });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
      glfwSetWindowShouldClose(w, GLFW_FALSE);  // there may be something to save first
      of(w).gui_->ui().requests.quit = true;
      of(w).wakeUp();
    });
    glfwSetWindowSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).wakeUp(); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).wakeUp(); });
  }

  StateLog stateLog_;
  WindowHandle handle_;
  std::unique_ptr<Gui> gui_;
  std::unique_ptr<ShotJob> shotJob_;
  std::unique_ptr<WindowFiles> files_;
  std::string title_;
  int place_[4] = {60, 60, 1280, 800};  // of the window, while it fills the screen
  double lastFrame_ = 0, lastEvent_ = 0;
  int framesOwed_ = 3;
  KeyTaps keyTaps_;
  InputCounts received_;
};

}  // namespace

void runWindow(const WindowOptions& options) {
  installCrashHandler();
  const Glfw glfw;
  std::string message;
  Preferences preferences = loadPreferences(preferencesPath(), message);
  if (options.theme) preferences.theme = *options.theme;
  if (!options.language.empty()) preferences.language = options.language;
  if (options.uiScale) preferences.uiScale = *options.uiScale;
  if (!message.empty()) printLine(stderr, message);
  MainWindow(options, preferences).run();
}

}  // namespace anamorph
