#include "app/render_job.h"

#include <algorithm>
#include <utility>

#include "base/language.h"
#include "base/text.h"
#include "panels/file_flow.h"
#include "pipeline/picture.h"
#include "raytrace/png.h"

namespace anamorph {

bool RenderJob::update(const LevelResult& result, UiState& ui) {
  RenderDialog& dialog = ui.render;
  if (std::exchange(ui.requests.startRender, false) && result.original.mesh) {
    dialog.message.clear();
    start(result, dialog);
  }
  if (std::exchange(ui.requests.cancelRender, false)) {
    worker_.cancel();
    dialog.message = tr("Cancelled.");
  }
  if (const auto path = std::exchange(ui.requests.saveRender, std::nullopt); path && picture_) {
    dialog.saving = path->string();
    save(dialog.saving);
  }
  bool changed = false;
  if (auto picture = results_->take()) {
    picture_ = std::move(*picture);
    changed = true;
  }
  if (auto failure = worker_.takeFailure()) {
    dialog.message = std::move(*failure);
    changed = true;
  }
  changed |= updateSaves(ui);
  const bool running = worker_.busy();
  changed |= running != dialog.running;
  dialog.running = running;
  dialog.fraction = worker_.fraction();
  return changed;
}

std::vector<std::filesystem::path> RenderJob::unwritten(double seconds) {
  const std::vector<std::string> files = saves_.undone(seconds);
  return {files.begin(), files.end()};
}

// Refined for the picture's own size first, as `anamorph render` does.
void RenderJob::start(const LevelResult& result, const RenderDialog& dialog) {
  Level level = result.level;
  const auto [width, height] = pictureSize(level.grid, dialog.longerSide);
  level.sculpture.imageSize = std::max(level.sculpture.imageSize, height);
  level.tracing.samplesPerAxis = dialog.samplesPerAxis;
  const ImageRequest request = makeImageRequest(level, width, height, 0);
  worker_.request([level, request, original = PlacedOriginal(result.original.mesh, result.source),
                   results = results_](const Progress& progress) {
    const auto finished = finishLevel(level, original, 0, {{}, progress.token});
    if (!finished) return;
    auto image = makePicture(*finished, PictureKind::reflection, request, nullptr, progress);
    if (image) results->put(std::make_shared<const Bitmap>(toBitmap(*image)));
  });
}

bool RenderJob::updateSaves(UiState& ui) {
  RenderDialog& dialog = ui.render;
  const bool idle = saves_.idle();  // before its outcomes: then they are all there
  bool changed = false;
  if (auto message = messages_->take()) {
    dialog.message = std::move(*message);
    changed = true;
  }
  for (const WriteQueue::Outcome& outcome : saves_.takeOutcomes()) {
    if (outcome.failure.empty()) continue;
    giveUpQuitting(ui, outcome.failure);
    dialog.message = outcome.failure;
    changed = true;
  }
  if (idle && !dialog.saving.empty()) {
    dialog.saving.clear();
    changed = true;
  }
  return changed;
}

void RenderJob::save(const std::string& file) {
  saves_.add(file, [file, picture = picture_, messages = messages_] {
    const std::vector<std::string> lost = savePng(file, *picture);
    messages->put(withRemarks(trFormat("{}: {} x {} pixels", file, picture->width, picture->height), lost));
  });
}

}  // namespace anamorph
