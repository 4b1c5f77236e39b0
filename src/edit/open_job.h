// A level's file is read in the background: the disk that it is on may be slow, or not answer at all. Nothing of the
// session changes until it is here; what goes wrong then comes out of take().
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>

#include "edit/session.h"
#include "pipeline/worker.h"

namespace anamorph {

class OpenJob {
 public:
  /// `wake` is called from the other thread when there is something to take.
  explicit OpenJob(std::function<void()> wake = {}) : worker_(std::move(wake)) {}

  /// Begins, in place of what is still being read.
  void start(std::filesystem::path path);
  void cancel();

  /// What was read, once; nothing before. Waits so long for it, for files that are here in no time. Throws Error
  /// when it cannot be read.
  std::optional<LevelFile> take(double patienceSeconds = 0);

  /// Whether there is something to wait for or to take.
  bool busy() const { return path_.has_value(); }
  /// That is being read.
  const std::filesystem::path& path() const { return *path_; }

 private:
  struct Outcome {
    std::optional<LevelFile> file;
    std::exception_ptr failure;
  };
  std::optional<std::filesystem::path> path_;
  std::shared_ptr<Mailbox<Outcome>> outcomes_;
  Worker worker_;  // last: its job uses the mailbox
};

}  // namespace anamorph
