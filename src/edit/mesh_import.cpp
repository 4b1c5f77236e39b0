#include "edit/mesh_import.h"

#include <utility>

#include "base/count.h"
#include "base/language.h"
#include "base/text.h"
#include "edit/level_files.h"
#include "edit/replacements.h"
#include "geometry/mesh_files.h"
#include "pipeline/original.h"

namespace anamorph {
namespace {

Box roomFor(const MeshImport& import, const Level& level, const Progress& progress) {
  if (!import.box.empty()) return import.box;
  if (findMissingMesh(level, import.levelPath)) return roomInSight(level);
  // Not known yet: a level that has just been opened.
  const auto own = loadOriginal(level.original.shape, import.levelPath, {}, &progress.token).mesh;
  return boundingBox(placeOriginal(*own, level.original.unitize, level.original.placement)->positions);
}

Level withSceneMesh(Level level, FileShape file, const Mesh& mesh) {
  level.original.shape = std::move(file);
  const auto placed = placeOriginal(mesh, level.original.unitize, level.original.placement);
  level.camera.target = boundingBox(placed->positions).centre();
  return level;
}

}  // namespace

EditResult importMesh(const MeshImport& import, const Level& level, const Progress& progress) {
  const LoadedMesh read = loadMesh(import.file, {}, &progress.token);
  std::string message = import.file.filename().string() + ": " +
                        countOf(read.mesh.positions.size(), "vertex", "vertices") + ", " +
                        countOf(read.mesh.triangles.size(), "triangle", "triangles");
  if (import.keepSize) {
    return {withSceneMesh(level, {.path = import.name}, read.mesh), withRemarks(message, read.warnings)};
  }
  const Box room = roomFor(import, level, progress);
  const auto* old = std::get_if<FileShape>(&level.original.shape);
  const auto placed = [&](ModelUp up) {
    const FileShape file{.path = import.name, .up = up};
    const Mesh mesh = standUp(read.mesh, up);
    return old ? withAnotherMesh(level, file, mesh, room) : withOriginal(level, file, mesh, room);
  };
  const bool isAgain = old && old->path == import.name;
  const ModelUp up = import.up ? *import.up : isAgain ? old->up : read.up.up;
  if (import.up || isAgain || up == ModelUp::z) return {placed(up), withRemarks(message, read.warnings)};
  message += ". " + upGuessText(read.up) + " " + tr("Ctrl+Z takes that back.");
  return {placed(up), withRemarks(message, read.warnings), placed(ModelUp::z)};
}

}  // namespace anamorph
