#include "level/level_library.h"

#include <algorithm>
#include <charconv>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/resources.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

// The headings of the list, each with the number of the first level that is below it.
struct LevelGroup {
  const char* title;
  int from;
};
constexpr int unnumbered = 1'000'000;
constexpr LevelGroup groups[] = {
    {"First steps", 0}, {"Mirrors", 5}, {"Glass and systems", 8}, {"Free", unnumbered}};

// Before its name: 12 of "12-lens".
int numberOf(const fs::path& file) {
  const std::string stem = file.stem().string();
  int number = unnumbered;
  const auto [end, problem] = std::from_chars(stem.data(), stem.data() + stem.size(), number);
  const bool isNumber = problem == std::errc() && *end == '-' && number >= 0 && number < unnumbered;
  return isNumber ? number : unnumbered;
}

const char* groupOf(const fs::path& file) {
  const char* title = groups[0].title;
  for (const LevelGroup& group : groups) {
    if (numberOf(file) >= group.from) title = group.title;
  }
  return title;
}

std::vector<fs::path> levelFiles(const fs::path& folder) {
  std::error_code problem;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (entry->path().extension() == ".json") files.push_back(entry->path());
  }
  if (problem) throw Error("cannot list the levels: " + problem.message(), folder.string());
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(numberOf(a), a.stem()) < std::pair(numberOf(b), b.stem());
  });
  return files;
}

bool isMeant(const fs::path& file, const std::string& name) {
  const std::string stem = file.stem().string();
  const std::size_t dash = stem.find('-');
  return name == stem ||
         (dash != std::string::npos && (name == stem.substr(0, dash) || name == stem.substr(dash + 1)));
}

}  // namespace

fs::path levelFolder() {
  return resourceFolder() / "levels";
}

std::vector<LevelEntry> listLevels(const fs::path& folder) {
  std::vector<LevelEntry> levels;
  for (const fs::path& file : levelFiles(folder)) {
    LevelEntry& entry = levels.emplace_back();
    entry.path = file;
    entry.name = file.stem().string();
    entry.group = groupOf(file);
    try {
      LoadedLevel loaded = loadLevel(file);
      entry.title = loaded.level.text->title;
      entry.lesson = std::move(loaded.lesson);
    } catch (const Error& error) {
      entry.problem = error.what();  // one broken file must not hide the others
    }
  }
  return levels;
}

fs::path findLevel(const std::string& nameOrPath) {
  const fs::path path = nameOrPath;
  std::error_code ignored;
  const bool isFile = fs::exists(path, ignored) && !fs::is_directory(path, ignored);
  if (isFile || path.has_parent_path() || path.has_extension()) return path;

  std::string names;
  for (const fs::path& file : levelFiles(levelFolder())) {
    if (isMeant(file, nameOrPath)) return file;
    names += (names.empty() ? "" : ", ") + file.stem().string();
  }
  throw Error("expected a file or one of the levels " + names + ", got \"" + nameOrPath + "\"");
}

}  // namespace anamorph
