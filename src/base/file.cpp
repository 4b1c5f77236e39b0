#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstring>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "base/error.h"
#include "base/folder.h"
#include "base/system_call.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

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
  std::error_code ignored;
  if (!S_ISREG(info.st_mode))
    throw Error("expected a file, got " + kindName(fs::status(path, ignored).type()), name);
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

}  // namespace anamorph
