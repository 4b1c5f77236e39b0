#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <random>
#include <thread>
#include <utility>

#include "base/error.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr int maxLinks = 40;  // as the kernel
constexpr std::string_view temporaryName = ".anamorph-XXXXXX";

std::string systemReason() {
  return std::strerror(errno);
}

std::string freshTemporaryName() {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> any(0, letters.size() - 1);
  std::string name(temporaryName);
  for (std::size_t i = name.find('X'); i < name.size(); ++i) name[i] = letters[any(random)];
  return name;
}

// Closes on every way out.
struct Descriptor {
  int value;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

std::string mebibytes(std::size_t bytes) {
  return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

// For messages; a link is what it leads to.
std::string kindOf(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

// Up to the end. In pieces, so that what nobody waits for any more ends soon.
FileBytes readAll(int file, const std::string& name, std::size_t maxBytes, std::string_view limitHelp,
                  const CancelToken* token) {
  constexpr std::size_t piece = std::size_t{4} << 20;
  struct stat info {};
  if (::fstat(file, &info) != 0) throw Error("cannot read: " + systemReason(), name);
  if (S_ISDIR(info.st_mode)) throw Error("expected a file, got a folder", name);
  const auto refuse = [&](const std::string& size) {
    std::string help = limitHelp.empty() ? "" : "; " + std::string(limitHelp);
    throw Error("expected at most " + mebibytes(maxBytes) + ", got " + size + help, name);
  };
  const bool sizeKnown = S_ISREG(info.st_mode) && info.st_size > 0;
  if (sizeKnown && static_cast<std::size_t>(info.st_size) > maxBytes) {
    refuse(mebibytes(static_cast<std::size_t>(info.st_size)));
  }

  // One spare byte shows the end of the file without growing once more; one is for the closing 0.
  std::size_t capacity = (sizeKnown ? static_cast<std::size_t>(info.st_size) : 64 * 1024) + 2;
  FileBytes bytes{std::unique_ptr<char[]>(new char[capacity]), 0};
  while (true) {
    if (token && token->cancelled()) throw Cancelled();
    if (bytes.size + 1 == capacity) {
      capacity *= 2;
      std::unique_ptr<char[]> larger(new char[capacity]);
      std::memcpy(larger.get(), bytes.data.get(), bytes.size);
      bytes.data = std::move(larger);
    }
    const std::size_t room = std::min(capacity - 1 - bytes.size, piece);
    const ssize_t got = ::read(file, bytes.data.get() + bytes.size, room);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error("cannot read: " + systemReason(), name);
    if (got == 0) break;
    bytes.size += static_cast<std::size_t>(got);
    if (bytes.size > maxBytes) refuse("more");
  }
  bytes.data[bytes.size] = 0;
  return bytes;
}

FileBytes readRegular(const fs::path& path, std::size_t maxBytes, std::string_view limitHelp,
                      const CancelToken* token) {
  const std::string name = path.string();
  // A pipe that nobody writes to would hang in open(); what is no regular file is refused below.
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)};
  if (file.value < 0) throw Error("cannot open: " + systemReason(), name);
  struct stat info {};
  if (::fstat(file.value, &info) != 0) throw Error("cannot read: " + systemReason(), name);
  if (!S_ISREG(info.st_mode)) throw Error("expected a file, got " + kindOf(info.st_mode), name);
  return readAll(file.value, name, maxBytes, limitHelp, token);
}

// Shared by who waits and the thread that reads, whichever lives longer.
struct Reading {
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  FileBytes bytes;
  std::exception_ptr failure;
};

}  // namespace

// A system call on a disk that does not answer cannot be cancelled, so the thread that is in it is left behind. It
// touches nothing but what it shares with us, and the end of the program ends it.
FileBytes readFile(const fs::path& path, std::size_t maxBytes, std::string_view limitHelp,
                   const CancelToken* token) {
  if (!token) return readRegular(path, maxBytes, limitHelp, nullptr);
  const auto reading = std::make_shared<Reading>();
  std::thread([reading, path, maxBytes, help = std::string(limitHelp), cancel = *token] {
    FileBytes bytes;
    std::exception_ptr failure;
    try {
      bytes = readRegular(path, maxBytes, help, &cancel);
    } catch (...) {
      failure = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(reading->mutex);
    reading->bytes = std::move(bytes);
    reading->failure = std::move(failure);
    reading->done = true;
    reading->ended.notify_one();
  }).detach();
  std::unique_lock<std::mutex> lock(reading->mutex);
  while (!reading->ended.wait_for(lock, std::chrono::milliseconds(10), [&] { return reading->done; })) {
    if (token->cancelled()) throw Cancelled();
  }
  if (reading->failure) std::rethrow_exception(std::exchange(reading->failure, nullptr));
  return std::move(reading->bytes);
}

FileBytes readStandardInput(std::size_t maxBytes, std::string_view limitHelp) {
  return readAll(STDIN_FILENO, standardInputName, maxBytes, limitHelp, nullptr);
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  std::error_code ignored;
  target_ = path_;
  for (int links = 0; fs::is_symlink(target_, ignored); ++links) {
    errno = ELOOP;
    if (links == maxLinks) fail(systemReason());
    target_ = target_.parent_path() / fs::read_symlink(target_, ignored);
  }
  const fs::file_status status = fs::status(target_, ignored);
  if (fs::is_directory(status)) throw Error("cannot write: expected a file, got a folder", path_.string());
  if (!target_.has_filename()) throw Error("cannot write: expected the name of a file", path_.string());
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (!fs::is_character_file(status)) {
      throw Error(
          std::string("cannot write: expected a file, got a ") + (fs::is_fifo(status) ? "pipe" : "device"),
          path_.string());
    }
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
    if (descriptor_ < 0) fail(systemReason());
    return;
  }
  if (fs::exists(status) && ::access(target_.c_str(), W_OK) != 0) fail(systemReason());

  // A new file is made with what the umask leaves (mkstemp's would be private); an old one keeps its mode.
  do {
    temporary_ = target_.parent_path() / freshTemporaryName();
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) {
    temporary_.clear();
    fail(systemReason());
  }
  if (fs::exists(status)) ::fchmod(descriptor_, static_cast<mode_t>(status.permissions()));
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(systemReason());
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  if (!temporary_.empty() && ::fsync(descriptor_) != 0) fail(systemReason());
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(systemReason());
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(systemReason());
  temporary_.clear();
}

void AtomicFile::fail(const std::string& what) const {
  throw Error("cannot write: " + what, path_.string());
}

void removeLeftTemporaries(const fs::path& folder) {
  constexpr std::string_view beginning = temporaryName.substr(0, temporaryName.find('X'));
  const auto oldest = fs::file_time_type::clock::now() - std::chrono::minutes(10);
  std::error_code problem, ignored;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    if (name.size() != temporaryName.size() || name.compare(0, beginning.size(), beginning) != 0) continue;
    if (!entry->is_regular_file(ignored) || entry->is_symlink(ignored)) continue;
    const auto written = entry->last_write_time(ignored);
    if (!ignored && written < oldest) fs::remove(entry->path(), ignored);
  }
}

void writeFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

}  // namespace anamorph
