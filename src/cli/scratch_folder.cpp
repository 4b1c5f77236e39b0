#include "cli/scratch_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/system_call.h"

namespace anamorph {

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "anamorph-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw Error("cannot make a folder: " + systemReason(), name);
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

ScratchFolder::ScratchFolder(ScratchFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

}  // namespace anamorph
