#include "base/same_file.h"

#include <algorithm>
#include <system_error>

#include "base/folder.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// Where a file that is not there yet would be made: behind a link that leads to nothing, too.
fs::path placeOf(const fs::path& path) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(behindLinks(path), ignored);
  const fs::path place = fs::weakly_canonical(whole, ignored);
  return ignored ? whole.lexically_normal() : place;
}

}  // namespace

bool isSameFile(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  const fs::file_status first = fs::status(a, ignored), second = fs::status(b, ignored);
  if (fs::exists(first) != fs::exists(second)) return false;
  if (!fs::exists(first)) return placeOf(a) == placeOf(b);
  return fs::is_regular_file(first) && fs::equivalent(a, b, ignored);  // device and inode
}

std::optional<fs::path> findSameFile(const fs::path& file, const std::vector<fs::path>& files) {
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const fs::path& other) { return isSameFile(file, other); });
  return found == files.end() ? std::nullopt : std::optional(*found);
}

}  // namespace anamorph
