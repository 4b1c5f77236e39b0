#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/kept_attributes.h"
#include "base/system_call.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

constexpr const char* mayBeLost = "but it may not outlive a power cut: ";

}  // namespace

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  std::error_code problem, ignored;
  target_ = behindLinks(path_);
  errno = ELOOP;
  if (fs::is_symlink(target_, ignored)) fail(systemReason());
  const fs::file_status status = fs::status(target_, problem);
  if (status.type() == fs::file_type::none) fail(problem.message());
  if (fs::is_directory(status)) throw Error("cannot write: expected a file, got a folder", path_.string());
  if (!target_.has_filename()) throw Error("cannot write: expected the name of a file", path_.string());
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (!fs::is_character_file(status))
      throw Error("cannot write: expected a file, got " + kindName(status.type()), path_.string());
    direct_ = retried([&] { return ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
    if (direct_ < 0) fail(systemReason());
    return;
  }
  expectReplaceable();
  // A new file is made with what the umask leaves; until it has the old one's owner and rights it is private.
  temporary_.emplace(target_.parent_path(), fs::exists(status) ? 0600 : 0666);
  if (temporary_->descriptor() < 0) fail(systemReason());
}

AtomicFile::~AtomicFile() {
  if (direct_ >= 0) ::close(direct_);
}

void AtomicFile::write(std::string_view bytes) {
  const int file = temporary_ ? temporary_->descriptor() : direct_;
  while (!bytes.empty()) {
    const ssize_t written = retried([&] { return ::write(file, bytes.data(), bytes.size()); });
    if (written < 0) fail(systemReason());
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::vector<std::string> AtomicFile::commit() {
  if (!temporary_) {
    if (::close(std::exchange(direct_, -1)) != 0 && errno != EINTR) fail(systemReason());
    return {};
  }
  expectReplaceable();
  std::vector<std::string> lost = keepAttributes(target_, temporary_->descriptor(), path_.string());
  if (!temporary_->finish()) fail(systemReason());
  const fs::path folder = target_.parent_path();
  if (!temporary_->moveTo(target_)) {
    const std::string reason = systemReason();
    std::error_code ignored;
    fail(folder.empty() || fs::is_directory(folder, ignored) ? reason : "its folder is gone");
  }
  if (!syncFolder(folder)) lost.push_back(path_.string() + ": written, " + mayBeLost + systemReason());
  return lost;
}

// Asked twice: until the new file is complete, another program may have put something else there.
void AtomicFile::expectReplaceable() const {
  std::error_code problem;
  const fs::file_type type = fs::symlink_status(target_, problem).type();
  if (type == fs::file_type::not_found) return;
  if (type == fs::file_type::none) fail(problem.message());
  if (type != fs::file_type::regular) fail("expected a file to replace, got " + kindName(type));
  if (::access(target_.c_str(), W_OK) != 0) fail(systemReason());
}

void AtomicFile::fail(const std::string& what) const {
  throw Error("cannot write: " + what, path_.string());
}

std::vector<std::string> writeFile(const fs::path& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  return file.commit();
}

void renameFile(const fs::path& from, const fs::path& to) {
  if (retried([&] { return ::rename(from.c_str(), to.c_str()); }) != 0) {
    throw Error("cannot be renamed to " + to.filename().string() + ": " + systemReason(), from.string());
  }
  if (!syncFolder(to.parent_path())) {
    throw Error("renamed to " + to.filename().string() + ", " + mayBeLost + systemReason(), from.string());
  }
}

}  // namespace anamorph
