// A level's file is written in the background: the disk that it goes to may be slow, or not answer at all. The session
// goes on meanwhile; what is written is the level as it was when that was asked for.
//
//   start(): [level as it goes into the file] --worker--> file     take(): the session learns that it is saved
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/session.h"
#include "pipeline/worker.h"

namespace anamorph {

/// What came of a level that was to be saved.
struct SaveOutcome {
  std::filesystem::path path;
  std::string failure;              ///< why it is not written; empty: it is
  bool isOfAnEarlierLevel = false;  ///< another one has been opened since
  bool changedElsewhere = false;    ///< not written, for another program has written the file meanwhile
  std::vector<std::string> lost;    ///< of the file that was replaced, what could not be kept
  std::optional<FileTime> time{};   ///< when it was written
};

class SaveJob {
 public:
  /// `wake` is called from the other thread when there is something to take.
  explicit SaveJob(std::function<void()> wake = {}) : worker_(std::move(wake)) {}

  /// Begins; finishes a change that goes on. Only when nothing is busy. `known`: when the file was written last as far
  /// as the session knows; one that was written at another time is not replaced. Nothing: it is, in any case.
  void start(Session& session, const std::filesystem::path& path,
             std::optional<FileTime> known = std::nullopt);

  /// What came of it, once, and the session knows it then; nothing before. Waits so long for it.
  std::optional<SaveOutcome> take(Session& session, double patienceSeconds = 0);

  /// Whether there is something to wait for or to take.
  bool busy() const { return saving_.has_value(); }
  /// That is being written.
  const std::filesystem::path& path() const { return saving_->path; }
  /// Waits so long for it; the file, when it is not written then.
  std::optional<std::filesystem::path> unwritten(double seconds);

 private:
  std::optional<SavedLevel> saving_;
  std::shared_ptr<Mailbox<SaveOutcome>> outcomes_ = std::make_shared<Mailbox<SaveOutcome>>();
  Worker worker_;  // last: its job uses the mailbox
};

}  // namespace anamorph
