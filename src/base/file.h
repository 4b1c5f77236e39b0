// Whole files in, whole files out. Only regular files are read: a pipe or a device may never end. A file is replaced
// atomically: until commit() succeeds the old one is untouched, so a full disk, a crash or a power cut never costs what
// was saved before. Whatever is to last is written this way (tests/architecture_test.cpp looks for others).
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/temporary_file.h"

namespace anamorph {

/// The bytes of a file, followed by one 0 that does not count.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  std::string_view view() const { return {data.get(), size}; }
};

/// Reads a regular file. Throws Error when it cannot, when it is anything else, or when it is larger than `maxBytes`;
/// `limitHelp` then tells how to raise the limit. With a token it throws Cancelled soon after that is cancelled,
/// even while the disk does not answer: what hangs in the system then is left to itself.
FileBytes readFile(const std::filesystem::path& path, std::size_t maxBytes, std::string_view limitHelp = {},
                   const CancelToken* token = nullptr);

/// Standard input up to its end, whatever it is connected to. Throws Error as readFile does.
FileBytes readStandardInput(std::size_t maxBytes, std::string_view limitHelp = {});

/// What messages call it.
inline constexpr const char* standardInputName = "standard input";

/// Writes a temporary file beside `path`, and on commit() flushes it to disk and renames it over `path`.
/// A link is followed; a device such as /dev/null is written to directly, a pipe or a disk is refused. Without commit()
/// nothing is left behind. Access rights, owner and attributes of the file that is replaced are kept
/// (kept_attributes.h).
class AtomicFile {
 public:
  /// Throws Error when the folder does not exist, cannot be written to, or `path` is a folder or read-only.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws Error, for example when the disk is full.
  void write(std::string_view bytes);
  /// From its return on the new file outlives a power cut, unless what it returns says that it may not. Returns what
  /// could not be kept of the old one, as whole messages. Throws Error; the old file is there then.
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
