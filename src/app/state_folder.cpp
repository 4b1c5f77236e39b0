#include "app/state_folder.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>

#include "app/file_lock.h"
#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "level/json_object.h"
#include "level/limits.h"
#include "panels/ui_state.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

// Behind those that are there already.
void append(const JsonValue& json, const std::string& key, Paths& paths, std::size_t most) {
  const JsonValue* list = findMember(json, key);
  if (!list) return;
  for (const JsonValue& item : list->items) {
    const bool usable = item.kind == JsonValue::Kind::string && item.text.size() <= limits::mostPathBytes &&
                        fs::path(item.text).is_absolute();
    const bool known = std::find(paths.begin(), paths.end(), item.text) != paths.end();
    if (usable && !known && paths.size() < most) paths.emplace_back(item.text);
  }
}

JsonValue listOf(const Paths& paths) {
  return textList(std::vector<std::string>(paths.begin(), paths.end()));
}

void appendKept(const fs::path& folder, RecentFiles& recent) {
  std::error_code ignored;
  if (!fs::exists(recentFile(folder), ignored)) return;
  try {
    const JsonValue json =
        parseJson(readFile(recentFile(folder), std::size_t{1} << 20).view(), recentFile(folder).string());
    append(json, "levels", recent.levels, maxRecentLevels);
    append(json, "folders", recent.folders, maxRecentFolders);
  } catch (const Error&) {
    // Nobody's work: it is written anew with the next level.
  }
}

}  // namespace

fs::path stateFolder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const bool usable = state && *state == '/';  // relative ones are to be ignored, says the standard
  return (usable ? fs::path(state) : homeFolder() / ".local/state") / "anamorph";
}

fs::path recentFile(const fs::path& folder) {
  return folder / "recent.json";
}

RecentFiles loadRecent(const fs::path& folder) {
  RecentFiles recent;
  appendKept(folder, recent);
  return recent;
}

void saveRecent(const fs::path& folder, RecentFiles recent) {
  makeFolder(folder);
  const SharedFileLock lock(recentFile(folder));
  appendKept(folder, recent);
  writeFile(
      recentFile(folder),
      formatJson(
          JsonObject().add("levels", listOf(recent.levels)).add("folders", listOf(recent.folders)).value()) +
          "\n");
}

}  // namespace anamorph
