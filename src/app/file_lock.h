// A lock file: one process has it, and the system takes it away when that process ends, however it ends. A file that
// somebody removes is no lock any more: the next one would make another.
#pragma once

#include <filesystem>
#include <string>

namespace anamorph {

/// A lock file that is held. Empty when it could not be had.
class FileLock {
 public:
  FileLock() = default;
  /// Makes the file where there is none. Not held afterwards when somebody else holds it, or it cannot be made.
  explicit FileLock(const std::filesystem::path& path);
  ~FileLock();
  FileLock(FileLock&& other) noexcept;
  FileLock& operator=(FileLock&& other) noexcept;

  bool held() const { return descriptor_ >= 0; }
  /// Whether it is held, and the file is still where others look for it.
  bool isInPlace() const;
  /// Why it is not held.
  const std::string& problem() const { return problem_; }
  /// Removes the file and lets go of it.
  void removeFile();

 private:
  std::filesystem::path path_;
  std::string problem_;
  int descriptor_ = -1;
};

/// Holds the lock of a file that several windows read and replace, "progress.lock" of "progress.json", as long as it
/// lives.
class SharedFileLock {
 public:
  /// Waits for it, at most `seconds`. Throws Error when it cannot be had.
  explicit SharedFileLock(std::filesystem::path file, double seconds = 5);
  ~SharedFileLock() { lock_.removeFile(); }
  SharedFileLock(const SharedFileLock&) = delete;
  SharedFileLock& operator=(const SharedFileLock&) = delete;

 private:
  FileLock lock_;
};

}  // namespace anamorph
