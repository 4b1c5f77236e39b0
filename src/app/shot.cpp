#include "app/shot.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "base/error.h"
#include "base/language.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "level/limits.h"

namespace anamorph {
namespace {

// Puts things back, whatever happens.
class Undisturbed {
 public:
  explicit Undisturbed(Gui& gui)
      : gui_(gui),
        size_(ImGui::GetIO().DisplaySize),
        scale_(ImGui::GetIO().DisplayFramebufferScale),
        mouse_(ImGui::GetIO().MousePos),
        status_(std::exchange(gui.editor().status, {})),  // it is about the picture that is being made
        panelsHidden_(gui.ui().panelsHidden),
        exportOpen_(gui.ui().exporting.open) {}
  ~Undisturbed() {
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = size_;
    io.DisplayFramebufferScale = scale_;
    io.MousePos = mouse_;
    gui_.ui().panelsHidden = panelsHidden_;
    gui_.ui().exporting.open = exportOpen_;
    gui_.setShotFactor(1);
    gui_.setTransparent(false);
    gui_.ui().bare = false;
    gui_.editor().status = status_;
  }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

  int width() const { return static_cast<int>(size_.x * scale_.x); }
  int height() const { return static_cast<int>(size_.y * scale_.y); }

 private:
  SavedTarget target_;
  Gui& gui_;
  ImVec2 size_, scale_, mouse_;
  Status status_;
  bool panelsHidden_, exportOpen_;
};

}  // namespace

void divideByAlpha(Bitmap& bitmap) {
  for (std::size_t i = 0; i < bitmap.bytes.size(); i += 4) {
    const int alpha = bitmap.bytes[i + 3];
    for (std::size_t c = 0; c < 3 && alpha > 0; ++c) {
      bitmap.bytes[i + c] =
          static_cast<std::uint8_t>(std::min(255, (bitmap.bytes[i + c] * 255 + alpha / 2) / alpha));
    }
  }
}

Bitmap withoutAlpha(const Bitmap& bitmap) {
  Bitmap opaque{bitmap.width, bitmap.height, 3, {}};
  opaque.bytes.reserve(bitmap.bytes.size() / 4 * 3);
  for (std::size_t i = 0; i < bitmap.bytes.size(); i += 4) {
    opaque.bytes.insert(opaque.bytes.end(), bitmap.bytes.begin() + static_cast<std::ptrdiff_t>(i),
                        bitmap.bytes.begin() + static_cast<std::ptrdiff_t>(i + 3));
  }
  return opaque;
}

Bitmap compose(const ShotLayers& layers) {
  Bitmap picture = layers.panels;
  const Bitmap& view = layers.view;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      std::uint8_t* above = &picture.bytes[4 * (static_cast<std::size_t>(y) * picture.width + x)];
      const int vx = x - layers.viewX, vy = y - layers.viewY;
      const bool seen = vx >= 0 && vy >= 0 && vx < view.width && vy < view.height;
      const std::uint8_t nothing[] = {0, 0, 0, static_cast<std::uint8_t>(layers.transparent ? 0 : 255)};
      const std::uint8_t* below =
          seen ? &view.bytes[4 * (static_cast<std::size_t>(vy) * view.width + vx)] : nothing;
      const int through = 255 - above[3];
      for (int c = 0; c < 4; ++c) {
        const int light = c == 3 ? below[3] : (below[c] * below[3] + 127) / 255;
        above[c] = static_cast<std::uint8_t>(std::min(255, above[c] + (light * through + 127) / 255));
      }
    }
  }
  if (!layers.transparent) return withoutAlpha(picture);
  divideByAlpha(picture);
  return picture;
}

Shot::Shot(Gui& gui, const ShotRequest& request) {
  const Undisturbed guard(gui);
  const int factor = std::clamp(request.factor, static_cast<int>(limits::shotFactor.min),
                                static_cast<int>(limits::shotFactor.max));
  const int width = guard.width() * factor, height = guard.height() * factor, most = Texture::maxSize();
  if (std::max(width, height) > most) {
    throw Error(
        trFormat("A picture of {} x {} pixels is too large for this graphics card, which "
                 "can make {}. Choose a smaller one.",
                 width, height, most));
  }
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
  io.DisplayFramebufferScale = {1, 1};
  io.MousePos = {-FLT_MAX, -FLT_MAX};
  gui.setShotFactor(factor);
  gui.setTransparent(request.transparent);
  gui.ui().bare = request.transparent && !request.panels;
  gui.ui().exporting.open = false;
  gui.ui().panelsHidden = !request.panels;
  const Framebuffer target(width, height, {TexelFormat::rgba8});
  constexpr int layoutFrames = 4;
  for (int i = 1; i < layoutFrames; ++i) gui.layOut();
  target.bind();
  input_ = gui.drawWithoutView();
  const Rect& view = gui.ui().layout.view;
  layers_ = {{width, height, 4, target.readPixels()},
             {},
             static_cast<int>(std::lround(view.x)),
             static_cast<int>(std::lround(view.y)),
             request.transparent};
  samples_ =
      QualityGovernor::best().samples / (factor == 3 ? 4 : factor);  // large ones need not be as smooth
}

void Shot::draw(double milliseconds) {
  viewport_.draw(input_, 1, 1, samples_, milliseconds);
}

ShotLayers Shot::takeLayers() {
  layers_.view = viewport_.readBack();
  return std::move(layers_);
}

}  // namespace anamorph
