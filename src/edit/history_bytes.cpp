#include "edit/history_bytes.h"

#include <set>
#include <string>
#include <variant>

namespace anamorph {
namespace {

std::size_t bytesOf(const std::string& text) {
  return text.capacity() > std::string().capacity() ? text.capacity() + 1 : 0;  // short ones are inside
}

std::size_t bytesOf(const LevelText& text) {
  std::size_t bytes = sizeof text + bytesOf(text.title) + bytesOf(text.description) + bytesOf(text.lesson) +
                      bytesOf(text.schema) + text.unknownKeys.capacity() * sizeof(UnknownKey);
  for (const UnknownKey& key : text.unknownKeys) {
    bytes += bytesOf(key.object) + bytesOf(key.key) + bytesOf(key.json);
  }
  return bytes;
}

std::size_t bytesOf(const SmoothMesh& surface) {
  return (surface.mesh.positions.size() + surface.normals.size()) * sizeof(Point) +
         (surface.mesh.triangles.size() + surface.corners.size()) * sizeof(Triangle);
}

std::size_t bytesWithoutShared(const Level& level) {
  std::size_t bytes = sizeof level + level.lights.capacity() * sizeof(PointLight) +
                      level.optic.parts.capacity() * sizeof(OpticPart);
  if (const auto* file = std::get_if<FileShape>(&level.original.shape)) bytes += bytesOf(file->path);
  return bytes;
}

// Adds one level after the other, and counts once what they share.
class Sum {
 public:
  std::size_t add(const Level& level) {
    bytes_ += bytesWithoutShared(level);
    if (shared_.insert(&*level.text).second) bytes_ += bytesOf(*level.text);
    add(level.optic);
    if (level.sculpture.frozen) add(level.sculpture.frozen->optic);
    const auto* file = std::get_if<FileShape>(&level.original.shape);
    if (file && shared_.insert(&*file->obj).second) bytes_ += bytesOf(*file->obj);
    return bytes_;
  }

 private:
  void add(const Optic& optic) {
    for (const OpticPart& part : optic.parts) {
      if (!shared_.insert(part.shape.operator->()).second) continue;
      bytes_ += bytesOf(part.shape);
      const SurfaceFile* file = surfaceFileOf(part.shape);
      if (file && file->mesh && shared_.insert(file->mesh.get()).second) bytes_ += bytesOf(*file->mesh);
    }
  }

  std::size_t bytes_ = 0;
  std::set<const void*> shared_;  // what was counted
};

}  // namespace

std::size_t bytesOf(std::span<const Level> levels) {
  Sum sum;
  std::size_t bytes = 0;
  for (const Level& level : levels) bytes = sum.add(level);
  return bytes;
}

std::size_t countWithin(std::span<const Level> levels, std::size_t bytes) {
  Sum sum;
  std::size_t count = 0;
  for (auto level = levels.rbegin(); level != levels.rend(); ++level, ++count) {
    if (sum.add(*level) > bytes && count > 0) break;
  }
  return count;
}

void dropCutSurfaces(Level& level) {
  const auto drop = [](Optic& optic) {
    for (OpticPart& part : optic.parts) part.shape = withoutCutSurface(part.shape);
  };
  drop(level.optic);
  if (level.sculpture.frozen) drop(level.sculpture.frozen->optic);
}

void shareText(Level& level, std::span<const Level> others) {
  for (const Level& other : others) {
    if (&*level.text == &*other.text) return;
  }
  for (const Level& other : others) {
    if (!(level.text == other.text)) continue;
    level.text = other.text;
    return;
  }
}

}  // namespace anamorph
