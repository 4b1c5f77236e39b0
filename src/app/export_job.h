// Files to take home, made by a worker of its own from the settled level: what the export window asks for
// waits until the sculpture is refined and matched, and a drag that goes on meanwhile changes nothing in it.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "panels/ui_state.h"
#include "pipeline/worker.h"

namespace anamorph {

class ExportJob {
 public:
  explicit ExportJob(std::function<void()> wake) : worker_(std::move(wake)) {}

  /// Once a frame: starts and cancels as the window asks, and tells it how far things are and what came of
  /// them. A file that was written counts for the lesson.
  void update(Editor& editor, UiState& ui);

  /// Waits so long for the file that was asked for; it, when it is not written then.
  std::optional<std::filesystem::path> unwritten(double seconds);

 private:
  struct Outcome {
    std::string message;
    std::vector<std::string> lines;                         ///< warnings
    std::vector<std::pair<std::string, std::string>> rows;  ///< the print check
    bool written = false;
  };
  enum class Task { write, check };

  void start(Task task, const LevelResult& result, const ExportDialog& dialog);

  std::optional<Task> waiting_;
  std::optional<std::filesystem::path> writing_;  // from the wish to its outcome, or until it is cancelled
  Level startedWith_;                             // the last task
  Level level_;                                   // that was there in the last frame
  bool cancelled_ = false;                        // and what became of it is not known yet
  std::shared_ptr<Mailbox<Outcome>> outcomes_ = std::make_shared<Mailbox<Outcome>>();
  Worker worker_;  // last: its jobs use the mailbox
};

}  // namespace anamorph
