#include "base/temporary_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <climits>
#include <csignal>
#include <random>
#include <string>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/system_call.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view namePattern = ".anamorph-XXXXXX";
constexpr std::string_view nameBeginning = namePattern.substr(0, namePattern.find('X'));

// The names that a signal removes. A handler may neither lock nor allocate, so they stand in place.
struct NameSlot {
  std::atomic<bool> taken{false}, filled{false};
  char path[PATH_MAX] = {};
};
static_assert(std::atomic<bool>::is_always_lock_free);
std::array<NameSlot, 32> slots;

// Negative when all are taken or the name is too long: then the next temporary in the folder removes it.
int takeSlot(const std::string& path) {
  if (path.size() >= sizeof(NameSlot::path)) return -1;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    if (slots[i].taken.exchange(true)) continue;
    path.copy(slots[i].path, path.size());
    slots[i].path[path.size()] = 0;
    slots[i].filled = true;
    return static_cast<int>(i);
  }
  return -1;
}

void giveSlot(int slot) {
  if (slot < 0) return;
  slots[static_cast<std::size_t>(slot)].filled = false;
  slots[static_cast<std::size_t>(slot)].taken = false;
}

extern "C" void removeTemporariesAndEnd(int signal) {
  removeTemporaries();
  ::raise(signal);  // blocked while this runs, then the default action: see SA_RESETHAND
}

std::string freshName() {
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
  std::random_device random;
  std::uniform_int_distribution<std::size_t> any(0, letters.size() - 1);
  std::string name(namePattern);
  std::generate(name.begin() + nameBeginning.size(), name.end(), [&] { return letters[any(random)]; });
  return name;
}

// How old they are is told by the clock that `fresh` was made by: a file server's may be hours beside ours.
void removeLeftTemporaries(const fs::path& folder, const fs::path& fresh) {
  std::error_code problem, ignored;
  const auto oldest = fs::last_write_time(fresh, problem) - std::chrono::minutes(10);
  if (problem) return;
  for (fs::directory_iterator entry(folder.empty() ? "." : folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const std::string name = entry->path().filename().string();
    if (name.size() != namePattern.size() || !name.starts_with(nameBeginning)) continue;
    if (!entry->is_regular_file(ignored) || entry->is_symlink(ignored)) continue;
    const auto written = entry->last_write_time(ignored);
    if (!ignored && written < oldest) fs::remove(entry->path(), ignored);
  }
}

}  // namespace

TemporaryFile::TemporaryFile(const fs::path& folder, mode_t mode) {
  do {
    giveSlot(slot_);
    path_ = folder / freshName();
    slot_ = takeSlot(path_.string());  // first: a signal may come as soon as the file is there
    descriptor_ =
        retried([&] { return ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode); });
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) {
    path_.clear();
  } else {
    removeLeftTemporaries(folder, path_);
  }
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!path_.empty()) ::unlink(path_.c_str());
  giveSlot(slot_);
}

bool TemporaryFile::finish() {
  const bool flushed = retried([&] { return ::fsync(descriptor_); }) == 0;
  if (!flushed) return false;
  const int closed = ::close(std::exchange(descriptor_, -1));
  return closed == 0 || errno == EINTR;  // which closes it on Linux, and on disk it is already
}

bool TemporaryFile::moveTo(const fs::path& target) {
  if (retried([&] { return ::rename(path_.c_str(), target.c_str()); }) != 0) return false;
  path_.clear();
  return true;
}

ScratchFolder::ScratchFolder() {
  std::error_code problem;
  const fs::path place = fs::temp_directory_path(problem);
  if (problem) throw Error("no place for temporary files: " + problem.message());
  std::string name = (place / "anamorph-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw Error("cannot make a folder: " + systemReason(), name);
  path_ = name;
  slots_.push_back(takeSlot(name));
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  for (const int slot : slots_) giveSlot(slot);
}

fs::path ScratchFolder::file(const std::string& name) {
  const fs::path file = path_ / name;
  slots_.push_back(takeSlot(file.string()));
  return file;
}

// The files first, so that folders are empty. Neither call does anything to what is the other's.
void removeTemporaries() noexcept {
  for (const NameSlot& slot : slots) {
    if (slot.filled) ::unlink(slot.path);
  }
  for (const NameSlot& slot : slots) {
    if (slot.filled) ::rmdir(slot.path);
  }
}

void removeTemporariesOnSignals() {
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {
    }, action{};
    if (::sigaction(signal, nullptr, &before) != 0 || before.sa_handler != SIG_DFL) continue;
    action.sa_handler = removeTemporariesAndEnd;
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace anamorph
