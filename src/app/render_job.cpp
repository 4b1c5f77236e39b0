#include "app/render_job.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/language.h"
#include "pipeline/picture.h"
#include "raytrace/png.h"

namespace anamorph {

bool RenderJob::update(const LevelResult& result, UiState& ui) {
  RenderDialog& dialog = ui.render;
  if (std::exchange(ui.requests.startRender, false) && result.original.mesh) start(result, dialog);
  if (std::exchange(ui.requests.cancelRender, false)) {
    worker_.cancel();
    dialog.message = tr("Cancelled.");
  }
  if (const auto path = std::exchange(ui.requests.saveRender, std::nullopt); path && image_)
    save(path->string());
  bool changed = false;
  if (auto image = results_->take()) {
    image_ = std::move(*image);
    dialog.message.clear();
    changed = true;
  }
  if (auto message = messages_->take()) {
    dialog.message = std::move(*message);
    changed = true;
  }
  if (auto failure = worker_.takeFailure()) {
    dialog.message = std::move(*failure);
    changed = true;
  }
  const bool running = worker_.busy();
  changed |= running != dialog.running;
  dialog.running = running;
  if (!running) saving_.reset();
  dialog.fraction = worker_.fraction();
  return changed;
}

std::optional<std::filesystem::path> RenderJob::unwritten(double seconds) {
  if (!saving_) return std::nullopt;
  const bool ended = worker_.waitForEnd(seconds);
  return ended && messages_->take() ? std::nullopt : saving_;
}

// Refined for the picture's own size first, as `anamorph render` does.
void RenderJob::start(const LevelResult& result, const RenderDialog& dialog) {
  Level level = result.level;
  const auto [width, height] = pictureSize(level.grid, dialog.longerSide);
  level.sculpture.imageSize = std::max(level.sculpture.imageSize, height);
  level.tracing.samplesPerAxis = dialog.samplesPerAxis;
  const ImageRequest request = makeImageRequest(level, width, height, 0);
  worker_.request(
      [level, request, mesh = result.original.mesh, results = results_](const Progress& progress) {
        const auto finished = finishLevel(level, mesh, 0, {{}, progress.token});
        if (!finished) return;
        auto image = makePicture(*finished, PictureKind::reflection, request, nullptr, progress);
        if (image) results->put(std::make_shared<const Image>(std::move(*image)));
      });
}

void RenderJob::save(const std::string& file) {
  saving_ = file;
  worker_.request([file, image = image_, messages = messages_](const Progress&) {
    savePng(file, *image);
    messages->put(fmt::format(fmt::runtime(tr("{}: {} x {} pixels")), file, image->width, image->height));
  });
}

}  // namespace anamorph
