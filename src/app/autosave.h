// Unsaved changes are kept in the state folder, so that a crash, an empty battery or a kill costs little.
// Each window has a file of its own, and a lock that the system takes away when the window dies, however it
// dies:
//
//   a window lives:   recovery-4711.lock held      recovery-4711.json   nobody else's business
//   it has died:      recovery-4711.lock free      recovery-4711.json   offered by the next one that starts
//
// What a crash would leave is made at once after every change, as bytes in memory (unsaved_bytes.h); the file is written
// by a worker some seconds later, atomically. It goes away when the level is saved, and when the window ends
// as it should. Installed levels that were left changed have such files, too.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/session.h"
#include "panels/recovery_dialog.h"
#include "pipeline/worker.h"

namespace anamorph {

/// A lock file that is held. Empty when it could not be had.
class FileLock {
 public:
  FileLock() = default;
  /// Makes the file where there is none. Not held afterwards when another process holds it.
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  bool held() const { return descriptor_ >= 0; }
  /// Removes the file and lets go of it.
  void removeFile();

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
};

/// A file in the state folder, and the lock by which nobody else offers it meanwhile.
struct RecoveryFile {
  std::filesystem::path file;  ///< empty: none yet
  FileLock lock;

  /// Both from the disk.
  void remove();
};

/// Something that was rescued, and what is in it.
struct Rescued : RecoveryFile {
  std::filesystem::path levelPath;
  Level level;
  std::optional<std::filesystem::file_time_type> fileTime;  ///< of the level's file, as that session knew it
  RecoveryEntry entry;
};

/// What windows that have died have left, newest first; files that cannot be read are among them and say why.
std::vector<Rescued> findRescued(const std::filesystem::path& folder);

class Autosave {
 public:
  explicit Autosave(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Ends as it should: nothing stays. While an exception is on its way, all stays.
  ~Autosave();

  /// Once a frame; `now` in seconds. Begins to write when it is time: three seconds after a change, at most
  /// every six seconds, and every two minutes while one goes on. Returns what went wrong with the last one.
  std::optional<std::string> update(const Session& session, double now);
  /// Likewise what the window has of levels that it has left: each in a file of its own, at once.
  std::optional<std::string> keepLeft(const std::map<std::filesystem::path, Level>& left);
  /// Writes at once. Throws Error.
  void writeNow(const Session& session);

  /// Seconds until update() has something to do though nothing happens; nothing when it has not.
  std::optional<double> secondsUntilDue(double now) const;

  static constexpr double restSeconds = 3, leastSeconds = 6, mostSeconds = 120;
  /// While a change goes on, a crash costs no more than this of it; otherwise nothing (crash_handler.h).
  static constexpr double prepareSeconds = 1;

 private:
  std::optional<double> due() const;
  struct Left {
    RecoveryFile slot;
    Level level;
  };
  RecoveryFile freshSlot() const;
  std::optional<std::string> prepare(const Session& session);
  void write(const Session& session, bool wait);

  std::filesystem::path folder_;
  RecoveryFile slot_;
  std::map<std::filesystem::path, Left> left_;
  std::optional<Level> kept_;      // that the file holds, or will
  std::optional<Level> prepared_;  // that a crash would leave
  std::optional<Level> seen_;      // of the last update, while it is modified
  bool onDisk_ = false, changing_ = false;
  double lastChange_ = 0, lastWrite_ = -1e9, lastPrepared_ = -1e9;
  std::unique_ptr<Worker> worker_;
};

}  // namespace anamorph
