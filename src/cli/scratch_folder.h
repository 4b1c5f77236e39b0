// A folder for files on the way to somewhere else; gone with the object.
#pragma once

#include <filesystem>

namespace anamorph {

class ScratchFolder {
 public:
  /// A new one, among the system's temporary files. Throws Error when none can be made.
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;  // empty: moved away
};

}  // namespace anamorph
