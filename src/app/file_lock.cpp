#include "app/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/system_call.h"

namespace anamorph {
namespace {

// Whoever held it may have removed the file meanwhile: then this is a lock that nobody else sees.
bool leadsTo(const std::filesystem::path& path, int descriptor) {
  struct stat opened {
  }, there{};
  return ::fstat(descriptor, &opened) == 0 && ::stat(path.c_str(), &there) == 0 &&
         opened.st_ino == there.st_ino && opened.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& path) : path_(path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) {
    problem_ = systemReason();
    return;
  }
  if (::flock(file, LOCK_EX | LOCK_NB) == 0 && leadsTo(path, file)) {
    descriptor_ = file;
    return;
  }
  problem_ = "another program has it";
  ::close(file);
}

FileLock::~FileLock() {
  if (held()) ::close(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)),
      problem_(std::move(other.problem_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(problem_, other.problem_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

bool FileLock::isInPlace() const {
  return held() && leadsTo(path_, descriptor_);
}

void FileLock::removeFile() {
  if (!held()) return;
  if (isInPlace()) ::unlink(path_.c_str());  // else it is somebody else's by now
  ::close(std::exchange(descriptor_, -1));
}

SharedFileLock::SharedFileLock(std::filesystem::path file, double seconds) {
  const std::filesystem::path path = file.replace_extension(".lock");
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (true) {
    lock_ = FileLock(path);
    if (lock_.held()) return;
    if (std::chrono::steady_clock::now() > end) {
      throw Error("cannot be locked: " + lock_.problem(), path.string());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

}  // namespace anamorph
