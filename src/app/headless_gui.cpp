#include "app/headless_gui.h"

#include <algorithm>
#include <cfloat>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <thread>

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "base/error.h"
#include "gl/offscreen_context.h"
#include "panels/actions.h"

namespace anamorph {

struct HeadlessContext::Parts {
  std::optional<OffscreenContext> egl;
  GLFWwindow* hidden = nullptr;

  ~Parts() {
    if (!hidden) return;
    glfwDestroyWindow(hidden);
    glfwTerminate();
  }
};

HeadlessContext::HeadlessContext() : parts_(std::make_unique<Parts>()) {
  std::string why;
  try {
    parts_->egl.emplace();
    return;
  } catch (const Error& error) {
    why = error.what();
  }
  if (!glfwInit()) throw Error("no picture can be drawn here: " + why + "; and there is no display either");
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  parts_->hidden = glfwCreateWindow(64, 64, "Anamorph", nullptr, nullptr);
  if (!parts_->hidden) {
    glfwTerminate();
    throw Error("no picture can be drawn here: " + why + "; and the display offers no OpenGL 3.3");
  }
  glfwMakeContextCurrent(parts_->hidden);
  loadGl(glfwGetProcAddress);
}

HeadlessContext::~HeadlessContext() = default;

HeadlessGui::HeadlessGui(int width, int height, Preferences preferences, int threads) {
  if (preferences.language.empty()) preferences.language = "en";  // the same picture on every machine
  gui_ = std::make_unique<Gui>(preferences, nullptr, threads);
  gui_->ui().headless = true;
  resize(width, height);
  moveMouse(-FLT_MAX, -FLT_MAX);
}

HeadlessGui::~HeadlessGui() = default;

void HeadlessGui::resize(int width, int height) {
  framebuffer_ = Framebuffer(std::max(1, width), std::max(1, height), {TexelFormat::rgba8});
}

void HeadlessGui::frame(double seconds, const ViewQuality* forced) {
  ImGui::GetIO().DisplaySize = {static_cast<float>(width()), static_cast<float>(height())};
  framebuffer_.bind();
  gui_->frame(seconds, forced);
  shotJob_.update(*gui_);
  ImGui::GetIO().MouseWheel = 0;
}

void HeadlessGui::settle() {
  const ViewQuality best = QualityGovernor::best();
  constexpr int layoutFrames = 4;  // Dear ImGui lays out in two, the view follows its size in one more
  for (int calm = 0; calm < layoutFrames;) {
    // Until the level is computed, nobody sees the pictures on the way.
    const ViewQuality draft{0.1, 1, 1};
    const LiveUpdater& updater = gui_->editor().updater;
    const bool computed = updater.result().complete && !updater.busy() && !isMoving(gui_->editor());
    frame(1.0 / 60, computed ? &best : &draft);
    const bool done = computed && !gui_->unfinished();
    calm = done ? calm + 1 : 0;
    if (!computed) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

void HeadlessGui::moveMouse(float x, float y) {
  ImGui::GetIO().MousePos = {x, y};
}
void HeadlessGui::pressMouse(int button, bool down) {
  ImGui::GetIO().MouseDown[button] = down;
}
void HeadlessGui::turnWheel(float steps) {
  ImGui::GetIO().MouseWheel = steps;
}
void HeadlessGui::holdModifiers(int modifiers) {
  ImGui::GetIO().KeyCtrl = (modifiers & keys::control) != 0;
  ImGui::GetIO().KeyShift = (modifiers & keys::shift) != 0;
}

Bitmap HeadlessGui::readBack() const {
  return {width(), height(), 4, framebuffer_.readPixels()};
}

}  // namespace anamorph
