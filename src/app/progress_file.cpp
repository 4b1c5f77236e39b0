#include "app/progress_file.h"

#include <fmt/format.h>

#include "app/file_lock.h"
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

std::string format(const LessonProgress& progress) {
  JsonObject lessons;
  for (const auto& [lesson, steps] : progress) {
    lessons.add(lesson, textList({steps.begin(), steps.end()}));
  }
  return formatJson(JsonObject()
                        .add("format", std::string("anamorph-progress"))
                        .add("version", std::size_t{1})
                        .add("lessons", lessons.value())
                        .value()) +
         "\n";
}

// The steps that are new, not all: another window may have been told to forget the others.
void add(LessonProgress& progress, const LessonProgress& now, const LessonProgress& before) {
  for (const auto& [lesson, steps] : now) {
    const auto known = before.find(lesson);
    for (const std::string& step : steps) {
      if (known == before.end() || known->second.count(step) == 0) progress[lesson].insert(step);
    }
  }
}

// What cannot be read is not written over.
void setAside(const fs::path& path) {
  renameFile(path, path.string() + ".broken");
}

}  // namespace

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

std::vector<std::string> saveProgress(const fs::path& path, const LessonProgress& before,
                                      const LessonProgress& now) {
  makeFolder(path.parent_path());
  const SharedFileLock lock(path);
  std::error_code ignored;
  const bool isThere = fs::exists(path, ignored);
  std::string broken;
  LessonProgress progress = loadProgress(path, broken);
  if (!broken.empty()) setAside(path);
  if (now.empty()) progress.clear();
  const LessonProgress nothing;
  add(progress, now, isThere && broken.empty() ? before : nothing);
  return writeFile(path, format(progress));
}

}  // namespace anamorph
