#include "base/folder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include "base/error.h"
#include "base/system_call.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

// The number that starts at `at`, without leading zeros; `at` moves behind it.
std::string_view numberAt(const std::string& text, std::size_t& at) {
  while (at < text.size() && text[at] == '0') ++at;
  const std::size_t begin = at;
  while (at < text.size() && isDigit(text[at])) ++at;
  return std::string_view(text).substr(begin, at - begin);
}

}  // namespace

bool comesBefore(const std::string& a, const std::string& b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (isDigit(a[i]) && isDigit(b[j])) {
      const std::string_view m = numberAt(a, i), n = numberAt(b, j);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
    } else {
      if (lower(a[i]) != lower(b[j])) {
        return static_cast<unsigned char>(lower(a[i])) < static_cast<unsigned char>(lower(b[j]));
      }
      ++i;
      ++j;
    }
  }
  const std::size_t restOfA = a.size() - i, restOfB = b.size() - j;
  return restOfA != restOfB ? restOfA < restOfB : a < b;
}

FolderListing listFolder(const fs::path& folder) {
  FolderListing listing;
  std::error_code problem, ignored;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    listing.entries.push_back({entry->path().filename().string(), entry->is_directory(ignored)});
  }
  if (problem) listing.problem = problem.message();
  std::sort(listing.entries.begin(), listing.entries.end(), [](const FolderEntry& a, const FolderEntry& b) {
    return a.isFolder != b.isFolder ? a.isFolder : comesBefore(a.name, b.name);
  });
  return listing;
}

void makeFolder(const fs::path& folder) {
  std::error_code failure;
  if (folder.empty() || fs::is_directory(folder, failure)) return;
  makeFolder(folder.parent_path());
  fs::create_directory(folder, failure);
  if (failure) throw Error("cannot make the folder: " + failure.message(), folder.string());
  if (!syncFolder(folder.parent_path())) {
    throw Error("cannot make the folder: " + systemReason(), folder.string());
  }
}

bool syncFolder(const fs::path& folder) {
  const char* name = folder.empty() ? "." : folder.c_str();
  const int file = retried([&] { return ::open(name, O_RDONLY | O_DIRECTORY | O_CLOEXEC); });
  if (file < 0) return errno == EACCES;
  const bool synced = retried([&] { return ::fsync(file); }) == 0 || errno == EINVAL || errno == ENOTSUP;
  const int reason = errno;
  ::close(file);
  errno = reason;
  return synced;
}

fs::path behindLinks(fs::path path) {
  constexpr int maxLinks = 40;  // as the kernel
  std::error_code ignored;
  for (int links = 0; links < maxLinks && fs::is_symlink(path, ignored); ++links) {
    path = path.parent_path() / fs::read_symlink(path, ignored);
  }
  return path;
}

std::string kindName(fs::file_type type) {
  return type == fs::file_type::directory ? "a folder"
         : type == fs::file_type::symlink ? "a link"
         : type == fs::file_type::fifo    ? "a pipe"
         : type == fs::file_type::socket  ? "a socket"
                                          : "a device";
}

std::string lowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), lower);
  return text;
}

std::string lowerEnding(const fs::path& path) {
  return lowerCase(path.extension().string());
}

fs::path homeFolder() {
  const char* home = std::getenv("HOME");
  return home && *home ? fs::path(home) : fs::path("/");
}

}  // namespace anamorph
