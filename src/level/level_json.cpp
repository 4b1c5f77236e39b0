#include "level/level_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "level/field_reader.h"
#include "level/field_writer.h"
#include "level/json.h"
#include "level/level_fields.h"
#include "level/scene_file.h"

namespace anamorph {
namespace {

constexpr std::array formats{"anamorph-level"};
enum class Format { level };

/// What a level file holds before the level itself.
struct Header {
  Format format = Format::level;
  int version = levelVersion;
};

template <typename At>
void fields(At& at, Header& header) {
  at.need({"format", "version"});
  at.choice("format", header.format, formats);
  at.field("version", header.version, limits::formatVersion);
  at.expect(header.version <= levelVersion, "version",
            fmt::format("at most {} (this level was made by a newer Anamorph, please update)", levelVersion));
}

Level readLevel(const JsonValue& document, FieldReader::Context& context) {
  FieldReader reader(document, "", context);
  // First: under another version every other complaint would mislead.
  Header header;
  fields(reader, header);
  Level level;
  fields(reader, level);
  reader.finish();
  level.text.edit([&](LevelText& text) { text.unknownKeys = context.unknownKeys; });
  return level;
}

bool isLevel(const JsonValue& document) {
  return findMember(document, "format") != nullptr;
}

}  // namespace

LoadedLevel parseLevel(std::string_view text, const std::string& fileName) {
  const JsonValue document = parseJson(text, fileName);
  FieldReader::Context context{fileName, {}};
  LoadedLevel loaded;
  loaded.isThesisScene = isThesisScene(document);
  if (!loaded.isThesisScene && !isLevel(document)) {
    throw Error(
        "expected a level (with \"format\": \"anamorph-level\") or a scene of the thesis (with \"Eye\" and "
        "\"Objects\"), got neither",
        fileName);
  }
  loaded.level = loaded.isThesisScene ? readThesisScene(document, context) : readLevel(document, context);
  loaded.lesson = parseLesson(loaded.level.text->lesson, fileName);
  for (const UnknownKey& unknown : context.unknownKeys) {
    loaded.warnings.push_back(fmt::format("{}: {}: unknown key, {}", fileName,
                                          shortened(joinJsonPath(unknown.object, unknown.key), 300),
                                          loaded.isThesisScene ? "ignored" : "kept but not used"));
  }
  return loaded;
}

std::string formatLevel(const Level& level) {
  Level copy =
      level;  // reading and writing share the functions that list the fields, and those take a reference
  Header header;
  FieldWriter writer("", level.text->unknownKeys);
  fields(writer, header);
  fields(writer, copy);
  return formatJson(writer.finish());
}

LoadedLevel loadLevel(const std::filesystem::path& path, const CancelToken* token) {
  const FileBytes bytes =
      readFile(path, maxLevelBytes, "a level names its model's file instead of holding it", token);
  return parseLevel(bytes.view(), path.string());
}

std::vector<std::string> saveLevel(const std::filesystem::path& path, const Level& level) {
  const std::string text = formatLevel(level);
  if (text.size() > maxLevelBytes) {
    throw Error(
        fmt::format("expected a level of at most {} MiB, got {} bytes", maxLevelBytes >> 20, text.size()),
        path.string());
  }
  parseLevel(text, path.string());
  return writeFile(path, text);
}

std::filesystem::path modelPath(const FileShape& shape, const std::filesystem::path& levelPath) {
  return levelPath.parent_path() / shape.path;
}

std::optional<std::filesystem::path> meshFileOf(const Level& level, const std::filesystem::path& levelPath) {
  const auto* file = std::get_if<FileShape>(&level.original.shape);
  if (!file || file->path.empty() || !file->obj->empty()) return std::nullopt;
  return modelPath(*file, levelPath);
}

}  // namespace anamorph
