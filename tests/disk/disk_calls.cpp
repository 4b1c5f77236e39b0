#undef _FORTIFY_SOURCE  // its inline open() would be in the way of ours

#include "disk/disk_calls.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <mutex>
#include <utility>

namespace anamorph::testing {
namespace {

struct Watched {
  std::string folder;  // with a slash at its end; empty: nothing is watched
  std::optional<DiskFault> fault;
  std::optional<DiskCall> failed;
  std::vector<DiskCall> calls;
  std::map<int, std::string> opened;
  std::size_t count = 0;
  bool halves = false;
  std::chrono::seconds clockAhead{0};
};

std::mutex mutex;
Watched watched;

// Relative to the folder; nothing outside of it. Tests name their files by absolute paths.
std::optional<std::string> inside(const std::string& path) {
  if (watched.folder.empty()) return std::nullopt;
  if (path + "/" == watched.folder) return "";
  if (!path.starts_with(watched.folder)) return std::nullopt;
  std::string rest = path.substr(watched.folder.size());
  while (rest.ends_with("/")) rest.pop_back();
  return rest;
}

std::optional<std::string> openedAs(int descriptor) {
  if (watched.folder.empty()) return std::nullopt;
  const auto found = watched.opened.find(descriptor);
  return found == watched.opened.end() ? std::nullopt : std::optional(found->second);
}

bool failsNow(const DiskCall& call) {
  if (!watched.fault || watched.count++ != watched.fault->index) return false;
  watched.failed = call;
  errno = watched.fault->error;
  return true;
}

// Makes the call, unless it is the one that fails, and notes it when it has succeeded.
template <typename Call>
auto pass(DiskCall change, const Call& call) -> decltype(call()) {
  if (failsNow(change)) {
    if (change.change == DiskChange::close) call();  // a descriptor is gone, whatever close() says
    return -1;
  }
  const auto result = call();
  if (result >= 0) {
    if (change.change == DiskChange::write) change.text.resize(static_cast<std::size_t>(result));
    if (change.change == DiskChange::openFile || change.change == DiskChange::openFolder) {
      change.descriptor = static_cast<int>(result);
    }
    watched.calls.push_back(std::move(change));
  }
  return result;
}

[[noreturn]] void secondWay(const char* function, const std::string& path) {
  std::fprintf(stderr, "%s(%s): files are written by AtomicFile only\n", function, path.c_str());
  std::abort();
}

}  // namespace

std::string describe(const DiskCall& call) {
  const std::string bytes = std::to_string(call.text.size()) + " bytes";
  switch (call.change) {
    case DiskChange::openFile:
      return "open " + call.path;
    case DiskChange::openFolder:
      return "open folder " + call.path;
    case DiskChange::write:
      return "write " + bytes + " to " + call.path;
    case DiskChange::truncate:
      return "truncate " + call.path;
    case DiskChange::sync:
      return "sync " + call.path;
    case DiskChange::syncFolder:
      return "sync folder " + call.path;
    case DiskChange::close:
      return "close " + call.path;
    case DiskChange::rename:
      return "rename " + call.path + " to " + call.text;
    case DiskChange::remove:
      return "remove " + call.path;
    case DiskChange::makeFolder:
      return "make folder " + call.path;
    case DiskChange::attribute:
      return "attribute of " + call.path;
  }
  return "?";
}

DiskWatch::DiskWatch(std::filesystem::path folder, std::optional<DiskFault> fault) {
  const std::lock_guard lock(mutex);
  watched = {};
  watched.folder = folder.string() + "/";
  watched.fault = fault;
}

DiskWatch::~DiskWatch() {
  const std::lock_guard lock(mutex);
  watched = {};
}

std::vector<DiskCall> DiskWatch::calls() const {
  const std::lock_guard lock(mutex);
  return watched.calls;
}

std::optional<DiskCall> DiskWatch::failed() const {
  const std::lock_guard lock(mutex);
  return watched.failed;
}

void DiskWatch::writeInHalves() {
  const std::lock_guard lock(mutex);
  watched.halves = true;
}

void DiskWatch::setClockAhead(std::chrono::seconds ahead) {
  const std::lock_guard lock(mutex);
  watched.clockAhead = ahead;
}

}  // namespace anamorph::testing

using namespace anamorph::testing;

extern "C" {

int open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  const auto call = [&] { return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode)); };
  const std::lock_guard lock(mutex);
  const auto name = inside(path);
  const bool folder = flags & O_DIRECTORY, writes = (flags & O_ACCMODE) != O_RDONLY;
  if (!name || (!folder && !writes)) return call();
  const int file = pass(
      {folder ? DiskChange::openFolder : DiskChange::openFile, *name, 0, {}, (flags & O_TRUNC) != 0}, call);
  if (file >= 0) watched.opened[file] = *name;
  return file;
}

int open64(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(more, mode_t) : 0;
  va_end(more);
  return open(path, flags, mode);
}

FILE* fopen64(const char* path, const char* mode) {
  {
    const std::lock_guard lock(mutex);
    if (inside(path) && mode[0] != 'r') secondWay("fopen", path);
  }
  using Open = FILE* (*)(const char*, const char*);
  static const auto real = reinterpret_cast<Open>(::dlsym(RTLD_NEXT, "fopen64"));
  return real(path, mode);
}

FILE* fopen(const char* path, const char* mode) {
  return fopen64(path, mode);
}

ssize_t write(int file, const void* bytes, size_t size) {
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  if (name && watched.halves && size > 1) size /= 2;
  const auto call = [&] { return static_cast<ssize_t>(::syscall(SYS_write, file, bytes, size)); };
  if (!name) return call();
  return pass({DiskChange::write, *name, file, std::string(static_cast<const char*>(bytes), size), 0}, call);
}

int ftruncate(int file, off_t size) noexcept {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_ftruncate, file, size)); };
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  return name ? pass({DiskChange::truncate, *name, file, {}, size}, call) : call();
}

int fsync(int file) {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_fsync, file)); };
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  struct stat info {};
  const bool folder = ::fstat(file, &info) == 0 && S_ISDIR(info.st_mode);
  return name ? pass({folder ? DiskChange::syncFolder : DiskChange::sync, *name, file, {}, 0}, call) : call();
}

int close(int file) {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_close, file)); };
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  if (!name) return call();
  watched.opened.erase(file);
  return pass({DiskChange::close, *name, file, {}, 0}, call);
}

int rename(const char* from, const char* to) noexcept {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to)); };
  const std::lock_guard lock(mutex);
  const auto name = inside(from), target = inside(to);
  return name && target ? pass({DiskChange::rename, *name, 0, *target, 0}, call) : call();
}

int unlink(const char* path) noexcept {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, 0)); };
  const std::lock_guard lock(mutex);
  const auto name = inside(path);
  return name ? pass({DiskChange::remove, *name, 0, {}, 0}, call) : call();
}

int remove(const char* path) noexcept {
  const int removed = unlink(path);
  if (removed == 0 || errno != EISDIR) return removed;
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, path, AT_REMOVEDIR));
}

int mkdir(const char* path, mode_t mode) noexcept {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_mkdirat, AT_FDCWD, path, mode)); };
  const std::lock_guard lock(mutex);
  const auto name = inside(path);
  return name ? pass({DiskChange::makeFolder, *name, 0, {}, 0}, call) : call();
}

int fchmod(int file, mode_t mode) noexcept {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_fchmod, file, mode)); };
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  return name ? pass({DiskChange::attribute, *name, file, {}, 0}, call) : call();
}

int fchown(int file, uid_t owner, gid_t group) noexcept {
  const auto call = [&] { return static_cast<int>(::syscall(SYS_fchown, file, owner, group)); };
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  return name ? pass({DiskChange::attribute, *name, file, {}, 0}, call) : call();
}

int fsetxattr(int file, const char* attribute, const void* value, size_t size, int flags) noexcept {
  const auto call = [&] {
    return static_cast<int>(::syscall(SYS_fsetxattr, file, attribute, value, size, flags));
  };
  const std::lock_guard lock(mutex);
  const auto name = openedAs(file);
  return name ? pass({DiskChange::attribute, *name, file, {}, 0}, call) : call();
}

int clock_gettime(clockid_t clock, timespec* time) noexcept {
  const int result = static_cast<int>(::syscall(SYS_clock_gettime, clock, time));
  const std::lock_guard lock(mutex);
  if (result == 0 && clock == CLOCK_REALTIME) time->tv_sec += watched.clockAhead.count();
  return result;
}
}
