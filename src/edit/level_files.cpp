#include "edit/level_files.h"

#include <utility>

#include "base/error.h"
#include "base/language.h"
#include "level/json.h"
#include "level/level_json.h"
#include "level/level_library.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& levelPath) {
  return levelPath.empty() ? fs::path() : cleanPath(levelPath).parent_path();
}

}  // namespace

fs::path cleanPath(const fs::path& file) {
  std::error_code failure;
  const fs::path whole = fs::absolute(file, failure);
  if (failure) return file;
  const fs::path folder = fs::weakly_canonical(whole.parent_path(), failure);
  return failure ? whole.lexically_normal() : folder / whole.filename();
}

bool isInstalledLevel(const fs::path& path) {
  if (path.empty()) return false;
  try {
    return cleanPath(path).parent_path() == fs::canonical(levelFolder());
  } catch (const std::exception&) {
    return false;  // none are installed
  }
}

std::string meshNameFor(const fs::path& mesh, const fs::path& levelPath) {
  const fs::path whole = cleanPath(mesh), folder = folderOf(levelPath);
  if (folder.empty()) return whole.string();
  const fs::path relative = whole.lexically_relative(folder);
  const bool below = !relative.empty() && *relative.begin() != "..";
  return below ? relative.string() : whole.string();
}

Level withMeshFrom(Level level, const fs::path& from, const fs::path& to) {
  auto* mesh = std::get_if<FileShape>(&level.original.shape);
  const bool stays =
      !mesh || mesh->path.empty() || (from.empty() == to.empty() && folderOf(from) == folderOf(to));
  if (!stays) mesh->path = meshNameFor(modelPath(*mesh, from), to);
  return level;
}

std::string windowTitle(const Session& session) {
  const fs::path& path = session.path();
  std::string title = tr(session.level().text->title);
  if (!path.empty() && !session.isInstalled()) {
    const std::string file = path.filename().string();
    title = title.empty() ? file : title + " (" + file + ")";
  }
  if (title.empty()) title = tr("Untitled");
  return title + (session.modified() ? " * - Anamorph" : " - Anamorph");
}

std::string levelAsText(const Level& level, const fs::path& path) {
  return compactJson(parseJson(formatLevel(withMeshFrom(level, path, {})), "the level"));
}

Level levelFromText(const std::string& text, const fs::path& path) {
  constexpr const char* name = "the text on the clipboard";
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw Error("expected a level, got nothing", name);
  LoadedLevel loaded = parseLevel(text, name);
  if (loaded.isThesisScene) throw Error("expected a level, got a scene of the thesis", name);
  return withMeshFrom(std::move(loaded.level), {}, path);
}

}  // namespace anamorph
