#include "app/shot_job.h"

#include <algorithm>
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

// Milliseconds between two frames that the picture gets: what the window's own view leaves of a frame's.
double frameShare(const Gui& gui) {
  constexpr double most = 50, least = 5;
  return std::max(least, most - gui.times().view);
}

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
    gui.editor().status.say(text);
  }
}

}  // namespace

void ShotJob::update(Gui& gui) {
  UiRequests& requests = gui.ui().requests;
  if (std::exchange(requests.cancelShot, false) && shot_) {
    shot_.reset();
    say(gui, tr("Cancelled. Nothing was written."));
  }
  const bool busy = !files_.idle();  // before its outcomes: then they are all there
  if (const auto message = messages_->take()) say(gui, *message);
  for (const WriteQueue::Outcome& outcome : files_.takeOutcomes()) {
    const bool asked = asked_.erase(outcome.name) > 0;
    if (outcome.failure.empty()) {
      gui.editor().exported += asked;
      continue;
    }
    giveUpQuitting(gui.ui(), outcome.failure);
    say(gui, outcome.failure);
  }
  if (const auto request = std::exchange(requests.shot, std::nullopt)) begin(gui, *request);
  if (shot_) shot_->draw(frameShare(gui));
  if (shot_ && shot_->complete()) write();
  const bool drawing = shot_ != nullptr;
  gui.ui().shot = {drawing || busy || !files_.idle(), drawing, drawing ? shot_->fraction() : 1,
                   path_.string()};
}

std::vector<fs::path> ShotJob::unwritten(double seconds) {
  const std::vector<std::string> names = files_.undone(seconds);
  std::vector<fs::path> files(names.begin(), names.end());
  if (shot_) files.push_back(path_.empty() ? "the picture of the window" : path_);
  return files;
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
  const std::string name =
      path_.empty() ? fmt::format("picture {} of the window", ++unnamed_) : path_.string();
  if (!path_.empty()) asked_.insert(name);
  files_.add(name, [layers, path = path_, messages = messages_] {
    const fs::path file = path.empty() ? freshScreenshotPath() : path;
    const std::vector<std::string> lost = savePng(file, compose(*layers));
    messages->put(withRemarks(trFormat("Written: {}", file.string()), lost));
  });
}

}  // namespace anamorph
