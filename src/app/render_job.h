// The high-resolution picture: rendered by a worker of its own, so that the window goes on and a drag does not cancel
// it. Pictures are saved by a queue: the next one that is rendered does not cancel that.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/write_queue.h"
#include "edit/live_updater.h"
#include "panels/ui_state.h"
#include "pipeline/worker.h"

namespace anamorph {

class RenderJob {
 public:
  explicit RenderJob(std::function<void()> wake) : saves_(wake), worker_(std::move(wake)) {}

  /// Starts, cancels and saves as the dialog asks, and tells it how far things are. Returns whether what the
  /// dialog shows has changed.
  bool update(const LevelResult& result, UiState& ui);

  /// Waits so long for the pictures that are being saved; the files of those that are not then.
  std::vector<std::filesystem::path> unwritten(double seconds);

  /// The last finished picture; null before the first.
  const std::shared_ptr<const Bitmap>& picture() const { return picture_; }

 private:
  void start(const LevelResult& result, const RenderDialog& dialog);
  void save(const std::string& file);
  bool updateSaves(UiState& ui);

  std::shared_ptr<const Bitmap> picture_;
  std::shared_ptr<Mailbox<std::shared_ptr<const Bitmap>>> results_ =
      std::make_shared<Mailbox<std::shared_ptr<const Bitmap>>>();
  std::shared_ptr<Mailbox<std::string>> messages_ = std::make_shared<Mailbox<std::string>>();
  WriteQueue saves_;
  Worker worker_;  // last: its jobs use the mailboxes
};

}  // namespace anamorph
