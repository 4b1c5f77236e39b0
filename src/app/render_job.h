// The high-resolution picture: rendered and saved by a worker of its own, so that the window goes on and a
// drag does not cancel it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "edit/live_updater.h"
#include "panels/ui_state.h"
#include "pipeline/worker.h"

namespace anamorph {

class RenderJob {
 public:
  explicit RenderJob(std::function<void()> wake) : worker_(std::move(wake)) {}

  /// Starts, cancels and saves as the dialog asks, and tells it how far things are. Returns whether what the
  /// dialog shows has changed.
  bool update(const LevelResult& result, UiState& ui);

  /// Waits so long for the picture that is being saved; its file, when it is not written then.
  std::optional<std::filesystem::path> unwritten(double seconds);

  /// The last finished picture; null before the first.
  const std::shared_ptr<const Image>& image() const { return image_; }

 private:
  void start(const LevelResult& result, const RenderDialog& dialog);
  void save(const std::string& file);

  std::shared_ptr<const Image> image_;
  std::optional<std::filesystem::path> saving_;  // until its outcome is known
  std::shared_ptr<Mailbox<std::shared_ptr<const Image>>> results_ =
      std::make_shared<Mailbox<std::shared_ptr<const Image>>>();
  std::shared_ptr<Mailbox<std::string>> messages_ = std::make_shared<Mailbox<std::string>>();
  Worker worker_;  // last: its jobs use the mailboxes
};

}  // namespace anamorph
