// Pictures of the window that were asked for, one at a time: each is drawn frame by frame, then put together and
// written by a worker. Told in the status line, and in the export window.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/shot.h"
#include "pipeline/worker.h"

namespace anamorph {

class ShotJob {
 public:
  explicit ShotJob(std::function<void()> wake = {}) : worker_(std::move(wake)) {}

  /// Once after every frame: begins and cancels as the panels ask, goes on with the picture for a while, and tells them
  /// how far it is and what came of it.
  void update(Gui& gui);

  /// Waits so long for the picture that is being written; its file, when it is not written then.
  std::optional<std::filesystem::path> unwritten(double seconds);

 private:
  void begin(Gui& gui, const ShotRequest& request);
  void write();

  std::unique_ptr<Shot> shot_;
  std::filesystem::path path_;  // where the user wants it; empty: anywhere
  struct Written {
    std::filesystem::path path;
    bool exported;                  ///< to where the user wanted it
    std::vector<std::string> lost;  ///< what could not be kept of a file that was there
  };
  std::shared_ptr<Mailbox<Written>> written_ = std::make_shared<Mailbox<Written>>();
  Worker worker_;  // last: its jobs use the mailbox
};

}  // namespace anamorph
