#include "level/level_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "base/file.h"
#include "level/field_reader.h"
#include "level/field_schema.h"
#include "level/field_writer.h"
#include "level/json_object.h"
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

/// The first version that can say all of it.
int versionOf(const Optic& optic, double depthOffset) {
  int version = depthOffset == 0 ? 1 : 2;
  for (const OpticPart& part : optic.parts) {
    version =
        std::max({version, shapeTypes()[shapeIndex(part.shape)].since, part.shape.clip().empty() ? 1 : 2});
  }
  return version;
}

int versionOf(const Level& level) {
  const SculptureSettings& sculpture = level.sculpture;
  const int version = versionOf(level.optic, sculpture.depthOffset);
  if (!sculpture.frozen) return version;
  return std::max(version, versionOf(sculpture.frozen->optic, sculpture.frozen->depthOffset));
}

Level readLevel(const JsonValue& document, FieldReader::Context& context) {
  FieldReader reader(document, "", context);
  Header header;
  fields(reader, header);
  context.remarks.throwFaults();  // under another version every other complaint would mislead
  Level level;
  fields(reader, level);
  reader.finish();
  level.text.edit([&](LevelText& text) { text.unknownKeys = context.unknownKeys; });
  return level;
}

/// A level file: FieldSchema walks both parts as one.
struct HeaderAndLevel {
  Header header;
  Level level;
};

void fields(FieldSchema& at, HeaderAndLevel& file) {
  fields(at, file.header);
  fields(at, file.level);
}

bool isLevel(const JsonValue& document) {
  return findMember(document, "format") != nullptr;
}

}  // namespace

LoadedLevel parseLevel(std::string_view text, const std::string& fileName) {
  LoadedLevel loaded;
  FileRemarks commas(fileName);
  loaded.document = parseJson(text, commas);
  loaded.isThesisScene = isThesisScene(loaded.document);
  if (!loaded.isThesisScene && !isLevel(loaded.document)) {
    throw Error(
        "expected a level (with \"format\": \"anamorph-level\") or a scene of the thesis (with \"Eye\" and "
        "\"Objects\"), got neither",
        fileName);
  }
  using UnknownKeys = FieldReader::UnknownKeys;
  FieldReader::Context context(fileName, loaded.isThesisScene ? UnknownKeys::ignored : UnknownKeys::kept);
  loaded.level =
      loaded.isThesisScene ? readThesisScene(loaded.document, context) : readLevel(loaded.document, context);
  const JsonValue* lesson = loaded.isThesisScene ? nullptr : findMember(loaded.document, "lesson");
  if (lesson) loaded.lesson = readLesson(*lesson, context.remarks);
  context.remarks.add(commas);
  context.remarks.throwFaults();
  loaded.warnings = context.remarks.warnings();
  return loaded;
}

std::string formatLevel(const Level& level) {
  Level copy =
      level;  // reading and writing share the functions that list the fields, and those take a reference
  Header header;
  header.version = versionOf(level);
  FieldWriter writer("", level.text->unknownKeys);
  fields(writer, header);
  fields(writer, copy);
  return formatJson(writer.finish());
}

std::string formatLevelSchema() {
  JsonObject schema;
  schema.add("$schema", std::string("https://json-schema.org/draft/2020-12/schema"));
  schema.add("title", std::string("A level of Anamorph"));
  const JsonValue file = schemaOf(HeaderAndLevel{});
  for (std::size_t i = 0; i < file.keys.size(); ++i) schema.add(file.keys[i], file.items[i]);
  return formatJson(schema.value());
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
