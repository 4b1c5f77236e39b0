#include "app/recovery_files.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <ctime>
#include <future>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "app/unsaved_bytes.h"
#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/language.h"
#include "edit/session.h"
#include "level/json_object.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

namespace fs = std::filesystem;

const JsonValue& member(const JsonValue& object, const std::string& key, JsonValue::Kind kind,
                        const std::string& file) {
  if (const JsonValue* value = findMember(object, key); value && value->kind == kind) return *value;
  throw Error("expected an unsaved level, got something else", file, "/" + key);
}

std::string absolutePath(const fs::path& path) {
  std::error_code failure;
  const fs::path absolute = path.empty() ? path : fs::absolute(path, failure);
  return (failure ? path : absolute).string();  // there may be no working folder any more
}

// A level's file, which may be on a disk that does not answer.
struct LevelNow {
  std::optional<FileTime> time;
  std::optional<Level> level;  // nothing: it cannot be read
};

LevelNow readNow(const fs::path& file) {
  LevelNow now{timeOf(file), {}};
  try {
    Session session;
    session.open({file, loadLevel(file), now.time});  // the meshes of mirrors need not be read to compare
    now.level = session.level();
  } catch (const Error&) {
    // Then what was rescued is all there is.
  }
  return now;
}

// What `look` makes of the file; nothing of it after half a second: then it is left to itself, and as long as that look
// hangs no other is begun.
template <typename Found>
Found lookAt(const fs::path& file, Found (*look)(const fs::path&)) {
  static std::atomic<int> looking = 0;
  constexpr int most = 4;  // several files, and windows in tests
  if (file.empty()) return {};
  if (looking.fetch_add(1) >= most) {
    --looking;
    return {};
  }
  std::packaged_task<Found()> task([file, look] {
    struct Leave {
      ~Leave() { --looking; }
    } leave;
    return look(file);
  });
  std::future<Found> found = task.get_future();
  std::thread(std::move(task)).detach();
  const bool answers = found.wait_for(std::chrono::milliseconds(500)) == std::future_status::ready;
  return answers ? found.get() : Found();
}

// Times of files are compared only by the system that made them: the count of its clock will do.
std::string textOf(const std::optional<FileTime>& time) {
  return time ? std::to_string(time->time_since_epoch().count()) : "";
}

std::optional<FileTime> timeIn(const JsonValue& json, const char* key) {
  const JsonValue* value = findMember(json, key);
  FileTime::rep count = 0;
  if (!value || value->text.empty()) return std::nullopt;
  const char* end = value->text.data() + value->text.size();
  const auto read = std::from_chars(value->text.data(), end, count);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return FileTime(FileTime::duration(count));
}

// The file as it is now goes with it: another one that is found later was written after this.
std::string format(const UnsavedLevel& unsaved, const std::string& level) {
  const auto seen = unsaved.fileTime ? lookAt(unsaved.path, timeOf) : std::nullopt;
  return formatJson(JsonObject()
                        .add("format", std::string("anamorph-recovery"))
                        .add("path", absolutePath(unsaved.path))
                        .add("time", static_cast<double>(std::time(nullptr)))
                        .add("fileTime", textOf(unsaved.fileTime))
                        .add("fileSeen", textOf(seen))
                        .add("level", parseJson(level, "the level"))
                        .value()) +
         "\n";
}

// A mirror of radius 0, for example, can be had in the window but not in a file.
bool canBeRead(const std::string& level) {
  try {
    parseLevel(level, "the level");
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::string timeText(std::time_t time) {
  const std::time_t now = std::time(nullptr);
  const double minutes = std::difftime(now, time) / 60;
  const std::string clock = fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(time));
  if (minutes < 1 || minutes > 24 * 60) return clock;
  if (minutes < 100) return trFormat("{}, {:.0f} minutes ago", clock, minutes);
  return trFormat("{}, {:.0f} hours ago", clock, minutes / 60);
}

// Returns whether its level's file holds the same.
bool read(Rescued& rescued) {
  const std::string name = rescued.file.string();
  const JsonValue json = parseJson(readFile(rescued.file, 2 * maxLevelBytes).view(), name);
  if (member(json, "format", JsonValue::Kind::string, name).text != "anamorph-recovery") {
    throw Error("expected an unsaved level, got something else", name, "/format");
  }
  rescued.path = member(json, "path", JsonValue::Kind::string, name).text;
  rescued.entry.level = rescued.path;
  rescued.fileTime = timeIn(json, "fileTime");
  const double time = member(json, "time", JsonValue::Kind::number, name).number;
  constexpr double latest = 1e11;  // seconds; clocks of thousands of years ahead cannot be written as dates
  if (!(time >= 0 && time <= latest)) throw Error("expected a time, got another number", name, "/time");
  rescued.entry.time = timeText(static_cast<std::time_t>(time));
  rescued.level = parseLevel(formatJson(member(json, "level", JsonValue::Kind::object, name)), name).level;
  rescued.entry.title = rescued.level.text->title.empty() ? tr("Untitled") : tr(rescued.level.text->title);
  const auto seen = timeIn(json, "fileSeen");
  const LevelNow now = lookAt(rescued.path, readNow);
  rescued.entry.fileIsNewer = seen && now.time && *seen != *now.time;
  if (rescued.entry.fileIsNewer) rescued.fileTime = now.time;
  return now.level == rescued.level;
}

fs::path lockOf(fs::path file) {
  return file.replace_extension(".lock");
}

std::vector<fs::path> filesIn(const fs::path& folder, const char* ending) {
  std::vector<fs::path> files;
  std::error_code problem;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const fs::path& file = entry->path();
    if (file.extension() == ending && file.filename().string().starts_with("recovery-"))
      files.push_back(file);
  }
  return files;
}

// Of windows that died when they had nothing to lose.
void removeLeftLocks(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& lock : filesIn(folder, ".lock")) {
    fs::path file = lock;
    if (!fs::exists(file.replace_extension(".json"), ignored)) FileLock(lock).removeFile();
  }
}

// A name that no other window has, living or dead.
RecoveryFile freshFile(const fs::path& folder) {
  std::string why;
  for (int i = 0; i < 100; ++i) {
    const std::string number = i == 0 ? "" : fmt::format("-{}", i);
    const fs::path file = folder / fmt::format("recovery-{}{}.json", ::getpid(), number);
    std::error_code ignored;
    if (fs::exists(file, ignored)) continue;
    FileLock lock(lockOf(file));
    if (lock.held()) return {file, std::move(lock)};
    why = lock.problem();
  }
  throw Error("cannot write: " + why, folder.string());
}

// What the file is to hold, and the file where there is none yet; nothing when the level could not be read again: the last
// one that can be is worth more.
std::optional<std::string> makeBytes(const fs::path& folder, RecoveryFile& kept,
                                     const UnsavedLevel& unsaved) {
  const std::string level = formatLevel(unsaved.level);
  if (!canBeRead(level)) return std::nullopt;
  makeFolder(folder);
  if (!kept.lock.isInPlace()) kept = freshFile(folder);
  return format(unsaved, level);
}

// The clock may have gone back; the times are what tells which one is the newest.
void makeNewest(const fs::path& file) {
  FileTime newest = FileTime::min();
  for (const fs::path& other : filesIn(file.parent_path(), ".json")) {
    if (other != file) newest = std::max(newest, timeOf(other).value_or(newest));
  }
  std::error_code ignored;
  if (timeOf(file).value_or(newest) <= newest) {
    fs::last_write_time(file, newest + std::chrono::milliseconds(10), ignored);
  }
}

}  // namespace

void RecoveryFile::remove() {
  std::error_code ignored;
  if (!file.empty()) fs::remove(file, ignored);
  lock.removeFile();
}

void prepareUnsaved(const fs::path& folder, RecoveryFile& kept, const UnsavedLevel& unsaved) {
  if (auto bytes = makeBytes(folder, kept, unsaved)) {
    putUnsaved(std::make_unique<UnsavedBytes>(absolutePath(kept.file), std::move(*bytes)));
  }
}

void keepUnsaved(const fs::path& folder, RecoveryFile& kept, const UnsavedLevel& unsaved) {
  if (const auto bytes = makeBytes(folder, kept, unsaved)) {
    writeFile(kept.file, *bytes);
    makeNewest(kept.file);
  }
}

std::vector<Rescued> findRescued(const fs::path& folder) {
  std::vector<Rescued> found;
  removeLeftLocks(folder);
  for (const fs::path& file : filesIn(folder, ".json")) {
    Rescued rescued{{file, FileLock(lockOf(file))}, {}, {}};
    if (!rescued.lock.held()) continue;  // of a window that lives
    std::error_code ignored;
    if (!fs::exists(rescued.file, ignored)) {
      rescued.lock.removeFile();  // it was ending just now
      continue;
    }
    try {
      if (read(rescued)) {
        rescued.remove();
        continue;
      }
    } catch (const Error& error) {
      rescued.entry.title = rescued.file.filename().string();
      rescued.entry.problem = error.what();
    }
    found.push_back(std::move(rescued));
  }
  std::sort(found.begin(), found.end(),
            [](const Rescued& a, const Rescued& b) { return timeOf(a.file) > timeOf(b.file); });
  return found;
}

}  // namespace anamorph
