#include "app/shot.h"

#include <algorithm>
#include <cfloat>
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
        message_(std::exchange(gui.editor().message, "")),  // it is about the picture that is being made
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
    gui_.editor().message = message_;
  }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;

  int width() const { return static_cast<int>(size_.x * scale_.x); }
  int height() const { return static_cast<int>(size_.y * scale_.y); }

 private:
  SavedTarget target_;
  Gui& gui_;
  ImVec2 size_, scale_, mouse_;
  std::string message_;
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

Bitmap takeShot(Gui& gui, const ShotRequest& request) {
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
  const Framebuffer target(width, height, {TexelFormat::rgba8});
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {static_cast<float>(target.width()), static_cast<float>(target.height())};
  io.DisplayFramebufferScale = {1, 1};
  io.MousePos = {-FLT_MAX, -FLT_MAX};
  gui.setShotFactor(factor);
  gui.setTransparent(request.transparent);
  gui.ui().bare = request.transparent && !request.panels;
  gui.ui().exporting.open = false;
  gui.ui().panelsHidden = !request.panels;
  // What is larger need not be as smooth.
  const ViewQuality finest = QualityGovernor::best(),
                    best{1, finest.samplesNow, finest.samples / (factor == 3 ? 4 : factor)};
  constexpr int layoutFrames = 4, mostFrames = 200;
  for (int i = 0; i < layoutFrames || (i < mostFrames && !gui.viewComplete()); ++i) {
    target.bind();
    gui.frame(1e-4, i + 1 < layoutFrames ? nullptr : &best);
  }
  Bitmap bitmap{target.width(), target.height(), 4, target.readPixels()};
  if (!request.transparent) return withoutAlpha(bitmap);
  divideByAlpha(bitmap);
  return bitmap;
}

}  // namespace anamorph
