#include "app/progress_file.h"

#include <utility>

#include <fmt/format.h>

#include "app/state_folder.h"
#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "level/json_object.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;
using Kind = JsonValue::Kind;

LessonProgress parse(const JsonValue& json, const std::string& file) {
  const auto expect = [&](bool holds, const std::string& where, const char* what, const JsonValue* got) {
    if (holds) return;
    throw Error(fmt::format("expected {}, got {}", what, got ? describeJson(*got) : "nothing"), file, where);
  };
  const JsonValue* format = findMember(json, "format");
  expect(format && format->text == "anamorph-progress", "/format", "\"anamorph-progress\"", format);
  const JsonValue* lessons = findMember(json, "lessons");
  expect(lessons && lessons->kind == Kind::object, "/lessons", "an object", lessons);
  LessonProgress progress;
  for (std::size_t i = 0; i < lessons->keys.size(); ++i) {
    const std::string where = joinJsonPath("/lessons", lessons->keys[i]);
    expect(lessons->items[i].kind == Kind::array, where, "an array of step ids", &lessons->items[i]);
    for (const JsonValue& step : lessons->items[i].items) {
      expect(step.kind == Kind::string, where, "an array of step ids", &step);
      progress[lessons->keys[i]].insert(step.text);
    }
  }
  return progress;
}

// What cannot be read is not written over.
void setAside(const fs::path& path) {
  renameFile(path, path.string() + ".broken");
}

}  // namespace

fs::path progressPath() {
  return stateFolder() / "progress.json";
}

LessonProgress loadProgress(const fs::path& path, std::string& message) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  try {
    return parse(parseJson(readFile(path, std::size_t{1} << 20).view(), path.string()), path.string());
  } catch (const Error& error) {
    message = error.what();
    return {};
  }
}

std::vector<std::string> saveProgress(const fs::path& path, LessonProgress progress) {
  makeFolder(path.parent_path());
  std::string broken;
  const LessonProgress others = loadProgress(path, broken);
  if (!broken.empty()) setAside(path);
  if (!progress.empty()) {
    for (const auto& [lesson, steps] : others) progress[lesson].insert(steps.begin(), steps.end());
  }
  JsonObject lessons;
  for (const auto& [lesson, steps] : progress) {
    lessons.add(lesson, textList({steps.begin(), steps.end()}));
  }
  return writeFile(path, formatJson(JsonObject()
                                        .add("format", std::string("anamorph-progress"))
                                        .add("version", std::size_t{1})
                                        .add("lessons", lessons.value())
                                        .value()) +
                             "\n");
}

}  // namespace anamorph
