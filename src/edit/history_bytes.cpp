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

// Shapes are shared as well, and are small: here each counts as its numbers.
std::size_t bytesWithoutText(const Level& level) {
  std::size_t bytes = sizeof level + level.lights.capacity() * sizeof(PointLight) +
                      level.optic.parts.capacity() * (sizeof(OpticPart) + sizeof(PackedShape));
  if (const auto* file = std::get_if<FileShape>(&level.original.shape)) bytes += bytesOf(file->path);
  return bytes;
}

// Adds one level after the other, and counts once what they share.
class Sum {
 public:
  std::size_t add(const Level& level) {
    bytes_ += bytesWithoutText(level);
    if (shared_.insert(&*level.text).second) bytes_ += bytesOf(*level.text);
    const auto* file = std::get_if<FileShape>(&level.original.shape);
    if (file && shared_.insert(&*file->obj).second) bytes_ += bytesOf(*file->obj);
    return bytes_;
  }

 private:
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
