#include "base/resources.h"

#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"

namespace anamorph {

std::filesystem::path resourceFolder() {
  namespace fs = std::filesystem;
  std::vector<fs::path> candidates;
  if (const char* chosen = std::getenv("ANAMORPH_RESOURCES")) candidates.emplace_back(chosen);
  std::error_code ignored;
  const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
  if (!program.empty()) candidates.push_back(program.parent_path().parent_path() / "share" / "anamorph");
  candidates.emplace_back(ANAMORPH_SOURCE_DIR);

  std::string searched;
  for (const fs::path& folder : candidates) {
    if (fs::is_directory(folder / "levels", ignored)) return folder;
    searched += (searched.empty() ? "" : ", ") + folder.string();
  }
  throw Error("the levels were not found; looked for a folder `levels` in " + searched +
              "; set ANAMORPH_RESOURCES to the folder that holds it");
}

}  // namespace anamorph
