// Unsaved changes are kept in the state folder, so that a crash, an empty battery or a kill costs little: the open level
// and those that were left changed, each in a file of its own (recovery_files.h). Autosave only says when; a queue writes,
// and no frame waits for it:
//
//   change  change change   change    change  change            a drag, for example
//   |-- gatherSeconds -->| kept           |-- leastSeconds -->| kept
//
// What is not wanted any more, because it is saved, goes away, but not before all that is wanted is kept. What a crash
// would leave of the open level is made as bytes in memory after every change, and does not wait for that
// (unsaved_bytes.h).
#pragma once

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/recovery_files.h"
#include "app/write_queue.h"
#include "edit/session.h"

namespace anamorph {

class Autosave {
 public:
  /// Levels that were left without saving, by their paths.
  using LeftLevels = std::map<std::filesystem::path, Level>;

  /// `wake` is called from another thread when update() has news.
  explicit Autosave(std::filesystem::path folder, std::function<void()> wake = {});
  /// Ends as it should: nothing stays. While an exception is on its way, all stays.
  ~Autosave();
  Autosave(const Autosave&) = delete;
  Autosave& operator=(const Autosave&) = delete;

  /// Once a frame; `now` in seconds of a clock that never goes back. Lets write what is due, and tries again what has
  /// failed. Returns what is to be said: why it failed, once, and when all is well again.
  std::optional<std::string> update(const Session& session, const LeftLevels& left, double now);
  /// The session's level is from now on what was rescued and is in this file.
  void adopt(RecoveryFile rescued);

  /// Seconds until update() has something to do though nothing happens; nothing when it has not.
  std::optional<double> secondsUntilDue(double now) const;
  /// Waits until what update() has let write is written, at most `seconds`. Returns whether it is.
  bool finish(double seconds) { return queue_.finish(seconds); }

  /// From the first change that is not kept, and between two writings: together the most that is ever lost.
  static constexpr double gatherSeconds = 1, leastSeconds = 4;
  /// A fault of the program costs no more than this of a change that goes on, and nothing else (crash_handler.h).
  static constexpr double prepareSeconds = 1;

 private:
  /// A level that is not saved.
  struct Document {
    std::shared_ptr<RecoveryFile> file = std::make_shared<RecoveryFile>();  // the queue's jobs have it
    std::optional<Level> kept;                                              // that the file holds, or will
    std::optional<double> changed;                                          // since when it is another one
    double written = -1e9;                                                  // when the last was let write

    double due() const { return std::max(*changed + gatherSeconds, written + leastSeconds); }
  };

  std::optional<std::string> takeNews();
  void want(const std::string& name, const std::filesystem::path& path, const Level& level,
            const std::optional<FileTime>& fileTime, double now);
  void prepare(const UnsavedLevel& unsaved, double now);
  void removeUnwanted(double now);

  std::filesystem::path folder_;
  std::map<std::string, Document> documents_;            // that are wanted, by the names of their jobs
  std::vector<std::shared_ptr<RecoveryFile>> unwanted_;  // files of others, that go away in time
  std::optional<Level> prepared_;                        // that a crash would leave
  double lastPrepared_ = -1e9;
  std::string failure_;  // that was said
  WriteQueue queue_;
};

}  // namespace anamorph
