#include "level/surface_files.h"

#include <utility>

namespace anamorph {
namespace {

struct FileFields : SomeShapeFields {
  explicit FileFields(const std::function<void(SurfaceFile&)>& each) : change(each) {}
  void file(const FieldName&, SurfaceFile& value) override { change(value); }
  const std::function<void(SurfaceFile&)>& change;
};

void changeFiles(Optic& optic, const std::function<void(SurfaceFile&)>& change) {
  FileFields fields(change);
  for (OpticPart& part : optic.parts) visitFields(part.shape, fields);
}

}  // namespace

void changeSurfaceFiles(LevelScene& level, const std::function<void(SurfaceFile&)>& change) {
  changeFiles(level.optic, change);
  if (level.sculpture.frozen) changeFiles(level.sculpture.frozen->optic, change);
}

std::filesystem::path surfacePath(const SurfaceFile& file, const std::filesystem::path& levelPath) {
  return levelPath.parent_path() / file.path;
}

std::vector<std::filesystem::path> surfaceFilesOf(const LevelScene& level,
                                                  const std::filesystem::path& levelPath) {
  std::vector<std::filesystem::path> files;
  LevelScene copy = level;
  changeSurfaceFiles(copy, [&](const SurfaceFile& file) {
    if (!file.path.empty()) files.push_back(surfacePath(file, levelPath));
  });
  return files;
}

}  // namespace anamorph
