// Whole files in, whole files out. A file is replaced atomically: until commit() succeeds the old one is
// untouched, so a full disk, a crash or a power cut never costs what was saved before. Whatever is to last is
// written this way (tests/architecture_test.cpp looks for others).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/temporary_file.h"

namespace anamorph {

/// The bytes of a file, followed by one 0 that does not count.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  std::string_view view() const { return {data.get(), size}; }
};

/// Reads a regular file (or a pipe). Throws Error when it cannot, or when it is larger than `maxBytes`;
/// `limitHelp` then tells how to raise the limit.
FileBytes readFile(const std::filesystem::path& path, std::size_t maxBytes, std::string_view limitHelp = {});

/// Writes a temporary file beside `path`, and on commit() flushes it to disk and renames it over `path`.
/// A link is followed; a device or a pipe is written to directly. Without commit() nothing is left behind.
/// Access rights, owner and attributes of the file that is replaced are kept (kept_attributes.h).
class AtomicFile {
 public:
  /// Throws Error when the folder does not exist, cannot be written to, or `path` is a folder or read-only.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws Error, for example when the disk is full.
  void write(std::string_view bytes);
  /// From its return on the new file outlives a power cut. Returns what could not be kept of the old one, as
  /// whole messages. Throws Error; the old file is there then, unless the message says that the new one is.
  std::vector<std::string> commit();

 private:
  void expectReplaceable() const;
  [[noreturn]] void fail(const std::string& what) const;

  std::filesystem::path path_;              // what the caller named, for messages
  std::filesystem::path target_;            // behind links
  std::optional<TemporaryFile> temporary_;  // nothing: written directly
  int direct_ = -1;
};

/// AtomicFile with one write.
std::vector<std::string> writeFile(const std::filesystem::path& path, std::string_view bytes);

/// Gives a file another name in the same folder, for good: from its return on that outlives a power cut. What
/// had the name is replaced. Throws Error.
void renameFile(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace anamorph
