#include "edit/level_files.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/language.h"
#include "geometry/obj_writer.h"
#include "level/level_json.h"
#include "level/level_library.h"
#include "level/limits.h"
#include "level/surface_files.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& levelPath) {
  return levelPath.empty() ? fs::path() : cleanPath(levelPath).parent_path();
}

bool isInside(const FileShape& mesh) {
  return !mesh.obj->empty();
}

// Whether there is a way from the folder to the file that does not go through the root.
bool haveFolderInCommon(const fs::path& file, const fs::path& folder) {
  const auto common = std::mismatch(file.begin(), file.end(), folder.begin(), folder.end()).first;
  return std::distance(file.begin(), common) > 1;
}

// Of a mesh's place what is below the level's folder, else only its name.
std::string sentName(const fs::path& mesh, const fs::path& levelPath) {
  if (!levelPath.empty()) {
    const fs::path relative =
        cleanPath(levelPath.parent_path() / mesh).lexically_relative(folderOf(levelPath));
    if (!relative.empty() && *relative.begin() != "..") return relative.string();
  }
  return mesh.has_filename() ? mesh.filename().string() : mesh.string();
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
  if (!haveFolderInCommon(whole, folder)) return whole.string();
  return whole.lexically_relative(folder).string();
}

Level withMeshFrom(Level level, const fs::path& from, const fs::path& to) {
  auto* mesh = std::get_if<FileShape>(&level.original.shape);
  const bool stays = !mesh || isInside(*mesh) || mesh->path.empty() ||
                     (from.empty() == to.empty() && folderOf(from) == folderOf(to));
  if (!stays) mesh->path = meshNameFor(modelPath(*mesh, from), to);
  if (from.empty() == to.empty() && folderOf(from) == folderOf(to)) return level;
  changeSurfaceFiles(level, [&](SurfaceFile& file) {
    if (!file.path.empty()) file.path = meshNameFor(surfacePath(file, from), to);
  });
  return level;
}

std::optional<fs::path> findMissingMesh(const Level& level, const fs::path& levelPath) {
  auto file = meshFileOf(level, levelPath);
  std::error_code failure;
  return file && !fs::exists(*file, failure) ? file : std::nullopt;
}

std::string levelAsText(const Level& level, const fs::path& path) {
  Level sent = level;
  auto* mesh = std::get_if<FileShape>(&sent.original.shape);
  if (mesh && isInside(*mesh)) {
    mesh->path = fs::path(mesh->path).filename().string();
  } else if (mesh) {
    mesh->path = sentName(mesh->path, path);
  }
  changeSurfaceFiles(sent, [&](SurfaceFile& file) { file.path = sentName(file.path, path); });
  return formatSentLevel(sent);
}

Level withMeshInside(Level level, const Mesh& mesh) {
  auto& file = std::get<FileShape>(level.original.shape);
  std::string obj = formatObj(mesh);
  if (obj.size() > limits::mostInsideBytes) {
    throw Error(
        trFormat("{} has {} kB as text, and at most {} kB can be inside a level. Copy the "
                 "level without it, and send its file, too.",
                 fs::path(file.path).filename().string(), obj.size() / 1000, limits::mostInsideBytes / 1000));
  }
  file.obj = std::move(obj);
  file.up = ModelUp::z;  // as `mesh` has it
  return level;
}

SentLevel levelFromText(const std::string& text, const Level& open, const fs::path& path) {
  SentLevel sent = readSentLevel(text, "the text on the clipboard");
  if (const auto missing = findMissingMesh(sent.level, path)) {
    const auto* known = std::get_if<FileShape>(&open.original.shape);
    if (known && fs::path(known->path).filename() == missing->filename()) {
      auto& file = std::get<FileShape>(sent.level.original.shape);
      // A mesh that is inside a level stands already.
      file = {known->path, known->obj, known->obj->empty() ? file.up : known->up};
    }
  }
  return sent;
}

}  // namespace anamorph
