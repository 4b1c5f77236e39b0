#include "base/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <random>
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
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
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
