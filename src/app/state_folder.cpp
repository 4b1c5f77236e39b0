#include "app/state_folder.h"

#include <algorithm>
#include <cstdlib>

#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "level/json_object.h"
#include "level/limits.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

fs::path recentFile(const fs::path& folder) {
  return folder / "recent.json";
}

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

}  // namespace

fs::path stateFolder() {
  const char* state = std::getenv("XDG_STATE_HOME");
  const bool usable = state && *state == '/';  // relative ones are to be ignored, says the standard
  return (usable ? fs::path(state) : homeFolder() / ".local/state") / "anamorph";
}

void loadRecent(const fs::path& folder, UiState& ui) {
  std::error_code ignored;
  if (!fs::exists(recentFile(folder), ignored)) return;
  try {
    const JsonValue json =
        parseJson(readFile(recentFile(folder), std::size_t{1} << 20).view(), recentFile(folder).string());
    append(json, "levels", ui.recentLevels, maxRecentLevels);
    append(json, "folders", ui.browser.recentFolders, maxRecentFolders);
  } catch (const Error&) {
    // Nobody's work: it is written anew with the next level.
  }
}

void saveRecent(const fs::path& folder, UiState& ui) {
  loadRecent(folder, ui);
  makeFolder(folder);
  writeFile(recentFile(folder), formatJson(JsonObject()
                                               .add("levels", listOf(ui.recentLevels))
                                               .add("folders", listOf(ui.browser.recentFolders))
                                               .value()) +
                                    "\n");
}

}  // namespace anamorph
