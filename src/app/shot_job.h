// Pictures of the window that were asked for, one at a time: each is drawn frame by frame, then put together and
// written by a thread of their own. Told in the status line, and in the export window.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/shot.h"
#include "app/write_queue.h"
#include "pipeline/worker.h"

namespace anamorph {

class ShotJob {
 public:
  explicit ShotJob(std::function<void()> wake = {}) : files_(std::move(wake)) {}

  /// Once after every frame: begins and cancels as the panels ask, goes on with the picture for a while, and tells them
  /// how far it is and what came of it.
  void update(Gui& gui);

  /// Waits so long for the pictures that are being written; those that are not written then.
  std::vector<std::filesystem::path> unwritten(double seconds);

 private:
  void begin(Gui& gui, const ShotRequest& request);
  void write();

  std::unique_ptr<Shot> shot_;
  std::filesystem::path path_;   // where the user wants it; empty: anywhere
  int unnamed_ = 0;              // pictures so far that may lie anywhere
  std::set<std::string> asked_;  // files that are being written where the user wanted them
  std::shared_ptr<Mailbox<std::string>> messages_ = std::make_shared<Mailbox<std::string>>();
  WriteQueue files_;
};

}  // namespace anamorph
