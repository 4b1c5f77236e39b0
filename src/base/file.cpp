#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"
#include "base/system_call.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// Closes on every way out of readFile.
struct Descriptor {
  int value;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

std::string mebibytes(std::size_t bytes) {
  return std::to_string((bytes + (1 << 20) - 1) >> 20) + " MiB";
}

}  // namespace

FileBytes readFile(const fs::path& path, std::size_t maxBytes, std::string_view limitHelp) {
  const std::string name = path.string();
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.value < 0) throw Error("cannot open: " + systemReason(), name);
  struct stat info {};
  if (::fstat(file.value, &info) != 0) throw Error("cannot read: " + systemReason(), name);
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
    if (bytes.size + 1 == capacity) {
      capacity *= 2;
      std::unique_ptr<char[]> larger(new char[capacity]);
      std::memcpy(larger.get(), bytes.data.get(), bytes.size);
      bytes.data = std::move(larger);
    }
    const ssize_t got = ::read(file.value, bytes.data.get() + bytes.size, capacity - 1 - bytes.size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw Error("cannot read: " + systemReason(), name);
    if (got == 0) break;
    bytes.size += static_cast<std::size_t>(got);
    if (bytes.size > maxBytes) refuse("more");
  }
  bytes.data[bytes.size] = 0;
  return bytes;
}

}  // namespace anamorph
