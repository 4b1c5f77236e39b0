#include "app/crash_handler.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "app/unsaved_bytes.h"

namespace anamorph {
namespace {

// Faults of the program, and the ends that others ask for: a log-out, Ctrl+C in the terminal.
constexpr std::array signals{SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGTERM, SIGHUP, SIGINT};

// A handler has no other way to anything. What was in force before: a sanitizer's, for example.
std::array<struct sigaction, signals.size()> before;
alignas(16) std::array<char, 1 << 16> stack;  // the program's own may be what is used up

bool writeAll(int file, std::string_view bytes) noexcept {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void leave(int signal) {
  writeUnsaved();
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (signals[i] == signal) ::sigaction(signal, &before[i], nullptr);
  }
  ::raise(signal);  // comes as soon as this one has returned
}

}  // namespace

void writeUnsaved() noexcept {
  const UnsavedBytes* const unsaved = takeUnsaved();
  constexpr std::string_view ending = ".last";
  static std::array<char, PATH_MAX> name;
  if (!unsaved || unsaved->file.size() + ending.size() >= name.size()) return;
  std::memcpy(name.data(), unsaved->file.data(), unsaved->file.size());
  std::memcpy(name.data() + unsaved->file.size(), ending.data(), ending.size());
  name[unsaved->file.size() + ending.size()] = 0;
  const int file = ::open(name.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0) return;
  const bool whole = writeAll(file, unsaved->bytes) && ::fsync(file) == 0;
  ::close(file);
  if (whole) {
    ::rename(name.data(), unsaved->file.c_str());
  } else {
    ::unlink(name.data());
  }
}

void installCrashHandler() {
  stack_t alternate{};
  alternate.ss_sp = stack.data();
  alternate.ss_size = stack.size();
  ::sigaltstack(&alternate, nullptr);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    if (::sigaction(signals[i], nullptr, &before[i]) != 0 || before[i].sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = leave;
    action.sa_flags = SA_ONSTACK;
    ::sigaction(signals[i], &action, nullptr);
  }
}

}  // namespace anamorph
