// Stands between the program and the system: every call by which files change is noted, and can be made to fail.
//
// disk_calls.cpp defines open(), write(), rename() and so on in the test program itself, so the whole program
// comes through it, the standard library, too: nothing in src/ knows of it. Without a DiskWatch, and outside its
// folder, the calls do what they always do. One watch at a time.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace anamorph::testing {

enum class DiskChange {
  openFile,
  openFolder,
  write,
  truncate,
  sync,
  syncFolder,
  close,
  rename,
  remove,
  makeFolder,
  attribute
};

/// One call that succeeded.
struct DiskCall {
  DiskChange change;
  std::string path;    ///< relative to the folder; of a file that is open: as it was opened
  int descriptor = 0;  ///< of open files and folders
  std::string text;    ///< rename: the new path; write: the bytes
  off_t offset = 0;    ///< truncate: the size; openFile: 1 where it truncates
};

/// For a message: "rename a/.anamorph-x1 to a/b.json".
std::string describe(const DiskCall& call);

/// A call that is not made, but fails.
struct DiskFault {
  std::size_t index = 0;  ///< which of the calls, from 0 on
  int error = 0;          ///< what errno says; EINTR: once, as a signal does
};

class DiskWatch {
 public:
  explicit DiskWatch(std::filesystem::path folder, std::optional<DiskFault> fault = std::nullopt);
  ~DiskWatch();
  DiskWatch(const DiskWatch&) = delete;
  DiskWatch& operator=(const DiskWatch&) = delete;

  /// What was called so far, those that failed not among them.
  std::vector<DiskCall> calls() const;
  /// What the fault met; nothing when there were fewer calls.
  std::optional<DiskCall> failed() const;
  /// From now on write() takes only half of what it is given (a single byte whole), as it may.
  void writeInHalves();
  /// From now on the program's clock is so far ahead of the disk's, as beside a file server's.
  void setClockAhead(std::chrono::seconds ahead);
};

}  // namespace anamorph::testing
