// What is kept on disk of levels that are not saved, and what is found of them after a crash. Each window has files of
// its own, and to each a lock that the system takes away when the window dies, however it dies:
//
//   a window lives:   recovery-4711.lock held      recovery-4711.json   nobody else's business
//   it has died:      recovery-4711.lock free      recovery-4711.json   offered by the next one that starts
//
// A window may also die between saving a level and removing what was kept of it. Then the level's file holds the same,
// and nothing is offered; or it was written after what was kept, and is newer. Times of files are only ever compared
// for being the same: clocks go back, and not all computers have the same.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/file_lock.h"
#include "edit/session.h"
#include "level/level.h"
#include "panels/recovery_dialog.h"

namespace anamorph {

/// A file in the state folder, and the lock by which nobody else offers it meanwhile.
struct RecoveryFile {
  std::filesystem::path file;  ///< empty: none yet
  FileLock lock;

  /// Both from the disk.
  void remove();
};

/// A level that is not saved.
struct UnsavedLevel {
  std::filesystem::path path;  ///< its file; empty: it has none yet
  Level level;
  std::optional<FileTime>
      fileTime;  ///< of that file when it was opened or saved; nothing: it is of no interest
};

/// Writes the level into the file, which is made where there is none or where somebody has removed it, with the folder.
/// Of a level that could not be read again nothing is written. Throws Error; what was kept before is still there then.
void keepUnsaved(const std::filesystem::path& folder, RecoveryFile& kept, const UnsavedLevel& unsaved);
/// Puts what keepUnsaved() would write where a crash finds it (unsaved_bytes.h), and writes nothing.
void prepareUnsaved(const std::filesystem::path& folder, RecoveryFile& kept, const UnsavedLevel& unsaved);

/// Something that was rescued, and what is in it.
struct Rescued : RecoveryFile, UnsavedLevel {
  RecoveryEntry entry;
};

/// What windows that have died have left, newest first; files that cannot be read are among them and say why. What
/// holds no more than its level's file does is removed. `fileTime` of one whose file is newer is that of the newer file:
/// who restores it knows of it.
std::vector<Rescued> findRescued(const std::filesystem::path& folder);

}  // namespace anamorph
