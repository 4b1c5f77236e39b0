// The file that is written beside another one whose place it will take. It must not stay, however its program ends:
// its object removes it; INT, TERM and HUP remove it (removeTemporariesOnSignals); and what a crash, a SIGKILL or a
// power cut has left is removed by the next one that is made in the folder.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace anamorph {

class TemporaryFile {
 public:
  /// In `folder`, with the access rights `mode` less what the umask takes, and a name that nobody has. Then removes
  /// those that programs which were killed have left there: that nobody has written to for ten minutes.
  TemporaryFile(const std::filesystem::path& folder, mode_t mode);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// For writing; negative when it could not be made, and errno says why.
  int descriptor() const { return descriptor_; }
  /// Ends writing, flushed to disk. False, and errno, when that fails.
  bool finish();
  /// Renames it over `target`, after finish(). False, and errno, when that fails.
  bool moveTo(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;  // empty: there is none any more
  int slot_ = -1;               // among the names that signals remove
  int descriptor_ = -1;
};

/// A folder among the system's temporary files; goes with this object and all that is in it, or by a signal.
class ScratchFolder {
 public:
  /// A new one. Throws Error when none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// The path of a file in it. Files that nobody has asked for in this way are no business of signals.
  std::filesystem::path file(const std::string& name);

 private:
  std::filesystem::path path_;
  std::vector<int> slots_;
};

/// From now on a process that INT, TERM or HUP ends removes what is temporary of it, and still dies of the signal. A
/// signal that whoever started the process has it ignore stays ignored. A file that grows beyond what the system
/// allows (ulimit -f) is an error instead of an end.
void removeTemporariesOnSignals();

/// Those that this program has; for an end that no destructor sees. Neither locks nor allocates.
void removeTemporaries() noexcept;

}  // namespace anamorph
