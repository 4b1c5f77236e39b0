#include "app/shot_job.h"

#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/folder.h"
#include "base/language.h"
#include "base/text.h"
#include "panels/file_flow.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr double frameShare = 50;  // ms between two frames that the picture gets

// Where F12 puts its pictures: beside the user's other pictures, never over an older one.
fs::path freshScreenshotPath() {
  std::error_code ignored;
  fs::path folder = homeFolder();
  if (fs::is_directory(folder / "Pictures", ignored)) folder /= "Pictures";
  for (int i = 1;; ++i) {
    fs::path path = folder / fmt::format("anamorph-{:03}.png", i);
    if (!fs::exists(path, ignored)) return path;
  }
}

// In the window that asked, or in the status line.
void say(Gui& gui, const std::string& text) {
  ExportDialog& dialog = gui.ui().exporting;
  if (dialog.open) {
    dialog.say(text);
  } else {
    gui.editor().message = text;
  }
}

}  // namespace

void ShotJob::update(Gui& gui) {
  UiRequests& requests = gui.ui().requests;
  const bool cancelled = requests.cancelShot || requests.cancelExport;
  requests.cancelShot = requests.cancelExport = false;
  if (cancelled && shot_) {
    shot_.reset();
    say(gui, tr("Cancelled. Nothing was written."));
  }
  const bool busy = worker_.busy();  // before its outcome is looked for: that comes first
  if (const auto written = written_->take()) {
    say(gui, withRemarks(trFormat("Written: {}", written->path.string()), written->lost));
    if (written->exported) ++gui.editor().exported;
  }
  if (const auto failure = worker_.takeFailure()) {
    giveUpQuitting(gui.ui(), *failure);
    say(gui, *failure);
  }
  if (const auto request = std::exchange(requests.shot, std::nullopt)) begin(gui, *request);
  if (shot_) shot_->draw(frameShare);
  if (shot_ && shot_->complete()) write();
  gui.ui().shot = {shot_ || busy || worker_.busy(), shot_ ? shot_->fraction() : 1, path_.string()};
}

std::optional<fs::path> ShotJob::unwritten(double seconds) {
  if (!shot_ && worker_.waitForEnd(seconds) && !worker_.takeFailure()) return std::nullopt;
  return path_.empty() ? "the picture of the window" : path_;
}

void ShotJob::begin(Gui& gui, const ShotRequest& request) {
  shot_.reset();
  path_ = request.path;
  try {
    shot_ = std::make_unique<Shot>(gui, request);
  } catch (const Error& error) {
    say(gui, error.what());
  }
}

void ShotJob::write() {
  const auto layers = std::make_shared<const ShotLayers>(shot_->takeLayers());
  shot_.reset();
  worker_.request([layers, path = path_, written = written_](const Progress&) {
    const fs::path file = path.empty() ? freshScreenshotPath() : path;
    const std::vector<std::string> lost = savePng(file, compose(*layers));
    written->put({file, !path.empty(), lost});
  });
}

}  // namespace anamorph
