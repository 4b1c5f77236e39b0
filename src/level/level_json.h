// Level files: JSON with "format": "anamorph-level", explained in levels/README.md. Reading is strict about
// types and ranges, and tells all faults at once; keys that are not known are warned about and survive load and save. The thesis' scene
// files are read too. Geometry that no sculpture can be made of (an eye on the mirror) is no fault of the
// file: the optics tell.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "level/json.h"
#include "level/lesson.h"
#include "level/level.h"

namespace anamorph {

constexpr int levelVersion = 2;
constexpr std::size_t maxLevelBytes = std::size_t{16} << 20;

struct LoadedLevel {
  Level level;
  Lesson lesson;                      ///< what level.text->lesson says
  std::vector<std::string> warnings;  ///< whole sentences with file, line and JSON pointer
  JsonValue document;                 ///< the file, with the places of everything in it
  /// From a scene file of the thesis: the original is a FileShape without a path that the caller fills in,
  /// and the camera's target is the mesh's position until the caller knows the original's box.
  bool isThesisScene = false;
};

/// Throws Error `file: where: expected, got` with all faults there are; `fileName` is only for messages.
LoadedLevel parseLevel(std::string_view text, const std::string& fileName);

/// All fields in a fixed order, indented by 2; parseLevel gives the same level again.
std::string formatLevel(const Level& level);

/// What a level file may hold, as a JSON Schema (draft 2020-12).
std::string formatLevelSchema();

/// parseLevel of a file of at most 16 MiB; throws Cancelled as readFile does.
LoadedLevel loadLevel(const std::filesystem::path& path, const CancelToken* token = nullptr);

/// Replaces the file atomically. Returns what could not be kept of the file that was replaced. Throws Error when it
/// cannot write it, or when the level has a value that loadLevel would refuse: what was saved can be opened.
std::vector<std::string> saveLevel(const std::filesystem::path& path, const Level& level);

/// Where the mesh of an original lies: relative paths start at the level's folder.
std::filesystem::path modelPath(const FileShape& shape, const std::filesystem::path& levelPath);

/// The mesh of an original that is in a file of its own; nothing for built-in shapes.
std::optional<std::filesystem::path> meshFileOf(const Level& level, const std::filesystem::path& levelPath);

}  // namespace anamorph
