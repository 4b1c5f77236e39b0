#include "app/autosave.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <ctime>
#include <exception>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include "app/crash_handler.h"
#include "app/unsaved_bytes.h"
#include "base/error.h"
#include "base/file.h"
#include "base/folder.h"
#include "base/language.h"
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

// Times of files are compared only by the system that made them: the count of its clock will do.
std::string textOf(const std::optional<fs::file_time_type>& time) {
  return time ? std::to_string(time->time_since_epoch().count()) : "";
}

std::optional<fs::file_time_type> fileTimeOf(const JsonValue& json) {
  const JsonValue* value = findMember(json, "fileTime");
  fs::file_time_type::rep count = 0;
  if (!value || value->text.empty()) return std::nullopt;
  const char* end = value->text.data() + value->text.size();
  const auto read = std::from_chars(value->text.data(), end, count);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return fs::file_time_type(fs::file_time_type::duration(count));
}

std::string format(const fs::path& path, const Level& level,
                   const std::optional<fs::file_time_type>& fileTime) {
  return formatJson(JsonObject()
                        .add("format", std::string("anamorph-recovery"))
                        .add("path", absolutePath(path))
                        .add("time", static_cast<double>(std::time(nullptr)))
                        .add("fileTime", textOf(fileTime))
                        .add("level", parseJson(formatLevel(level), "the level"))
                        .value()) +
         "\n";
}

// A mirror of radius 0, for example, can be had in the window but not in a file.
bool canBeRead(const Level& level) {
  try {
    parseLevel(formatLevel(level), "the level");
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

void read(Rescued& rescued) {
  const std::string name = rescued.file.string();
  const JsonValue json = parseJson(readFile(rescued.file, 2 * maxLevelBytes).view(), name);
  if (member(json, "format", JsonValue::Kind::string, name).text != "anamorph-recovery") {
    throw Error("expected an unsaved level, got something else", name, "/format");
  }
  rescued.levelPath = member(json, "path", JsonValue::Kind::string, name).text;
  rescued.entry.level = rescued.levelPath;
  rescued.fileTime = fileTimeOf(json);
  const double time = member(json, "time", JsonValue::Kind::number, name).number;
  constexpr double latest = 1e11;  // seconds; clocks of thousands of years ahead cannot be written as dates
  if (!(time >= 0 && time <= latest)) throw Error("expected a time, got another number", name, "/time");
  rescued.entry.time = timeText(static_cast<std::time_t>(time));
  rescued.level = parseLevel(formatJson(member(json, "level", JsonValue::Kind::object, name)), name).level;
  rescued.entry.title = rescued.level.text->title.empty() ? tr("Untitled") : tr(rescued.level.text->title);
}

fs::path lockOf(fs::path file) {
  return file.replace_extension(".lock");
}

bool isRecovery(const fs::path& file) {
  return file.extension() == ".json" && file.filename().string().starts_with("recovery-");
}

// Of windows that died when they had nothing to lose.
void removeLeftLocks(const fs::path& folder) {
  std::error_code problem, ignored;
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    const fs::path& lock = entry->path();
    fs::path file = lock;
    if (lock.extension() != ".lock" || fs::exists(file.replace_extension(".json"), ignored)) continue;
    FileLock(lock).removeFile();
  }
}

fs::file_time_type timeOf(const fs::path& file) {
  std::error_code failure;
  const auto time = fs::last_write_time(file, failure);
  return failure ? fs::file_time_type::min() : time;
}

}  // namespace

FileLock::FileLock(const fs::path& path) : path_(path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return;
  struct stat opened {
  }, there{};
  // Whoever held it may have removed the file meanwhile: then this is a lock that nobody else sees.
  const bool locked = ::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &opened) == 0 &&
                      ::stat(path.c_str(), &there) == 0 && opened.st_ino == there.st_ino;
  if (locked) {
    descriptor_ = file;
  } else {
    ::close(file);
  }
}

FileLock::~FileLock() {
  if (held()) ::close(descriptor_);
}

FileLock::FileLock(FileLock&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

void FileLock::removeFile() {
  if (!held()) return;
  ::unlink(path_.c_str());
  ::close(std::exchange(descriptor_, -1));
}

std::vector<Rescued> findRescued(const fs::path& folder) {
  std::vector<Rescued> found;
  std::error_code problem;
  removeLeftLocks(folder);
  for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
       entry.increment(problem)) {
    if (!isRecovery(entry->path())) continue;
    Rescued rescued{{entry->path(), FileLock(lockOf(entry->path()))}, {}, {}, {}, {}};
    if (!rescued.lock.held()) continue;  // of a window that lives
    std::error_code ignored;
    if (!fs::exists(rescued.file, ignored)) {
      rescued.lock.removeFile();  // it was ending just now
      continue;
    }
    try {
      read(rescued);
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

void RecoveryFile::remove() {
  std::error_code ignored;
  if (!file.empty()) fs::remove(file, ignored);
  lock.removeFile();
}

Autosave::~Autosave() {
  worker_.reset();                       // waits for what is being written
  if (std::uncaught_exceptions() > 0) {  // the program is failing: this is what it is for
    writeUnsaved();
    return;
  }
  putUnsaved(nullptr);
  slot_.remove();
  for (auto& [path, left] : left_) left.slot.remove();
}

// A name that no other window has, living or dead.
RecoveryFile Autosave::freshSlot() const {
  makeFolder(folder_);
  std::error_code ignored;
  for (int i = 0; i < 100; ++i) {
    const std::string number = i == 0 ? "" : fmt::format("-{}", i);
    const fs::path file = folder_ / fmt::format("recovery-{}{}.json", ::getpid(), number);
    FileLock lock(lockOf(file));
    if (!lock.held() || fs::exists(file, ignored)) continue;
    return {file, std::move(lock)};
  }
  throw Error("unsaved changes cannot be kept here", folder_.string());
}

std::optional<std::string> Autosave::keepLeft(const std::map<fs::path, Level>& left) {
  for (auto kept = left_.begin(); kept != left_.end();) {
    if (left.count(kept->first) > 0) {
      ++kept;
      continue;
    }
    kept->second.slot.remove();  // it is the open one again
    kept = left_.erase(kept);
  }
  std::optional<std::string> failure;
  for (const auto& [path, level] : left) {
    Left& kept = left_[path];
    if (!kept.slot.file.empty() && kept.level == level) continue;
    try {
      if (kept.slot.file.empty()) kept.slot = freshSlot();
      writeFile(kept.slot.file, format(path, level, std::nullopt));
      kept.level = level;
    } catch (const Error& error) {
      failure = error.what();
    }
  }
  return failure;
}

std::optional<double> Autosave::due() const {
  if (!seen_ || kept_ == seen_) return std::nullopt;
  const double often = lastWrite_ + mostSeconds;
  if (changing_) return std::max(often, lastChange_);
  return std::min(std::max(lastChange_ + restSeconds, lastWrite_ + leastSeconds),
                  std::max(often, lastChange_));
}

std::optional<double> Autosave::secondsUntilDue(double now) const {
  const auto time = due();
  if (!time) return std::nullopt;
  return std::max(0.0, *time - now);
}

// Puts the level where a crash finds it. Returns its text; nothing when it could not be read again: then the last one
// that can be is worth more.
std::optional<std::string> Autosave::prepare(const Session& session) {
  prepared_ = session.level();
  if (!canBeRead(session.level())) return std::nullopt;
  if (!slot_.lock.held()) slot_ = freshSlot();
  onDisk_ = true;  // a crash may put it there
  std::string text = format(session.path(), session.level(), session.fileTime());
  putUnsaved(std::make_unique<UnsavedBytes>(UnsavedBytes{slot_.file.string(), text}));
  return text;
}

void Autosave::write(const Session& session, bool wait) {
  if (const auto text = prepare(session)) {
    const auto job = [file = slot_.file, text = *text](const Progress&) { writeFile(file, text); };
    if (!worker_) worker_ = std::make_unique<Worker>();
    wait ? job({}) : worker_->request(job);
  }
  kept_ = session.level();
}

void Autosave::writeNow(const Session& session) {
  worker_.reset();
  write(session, true);
}

std::optional<std::string> Autosave::update(const Session& session, double now) {
  if (!session.modified()) {
    kept_.reset();
    prepared_.reset();
    putUnsaved(nullptr);
    if (std::exchange(onDisk_, false)) {
      if (!worker_) worker_ = std::make_unique<Worker>();
      worker_->request([file = slot_.file](const Progress&) {
        std::error_code ignored;
        fs::remove(file, ignored);
      });
    }
    seen_.reset();
    return std::nullopt;
  }
  const bool first = !seen_;
  if (first || !(*seen_ == session.level()) || changing_ != session.changing()) lastChange_ = now;
  if (first && lastWrite_ < 0) lastWrite_ = now - leastSeconds;  // the first one comes soon
  if (first || !(*seen_ == session.level())) seen_ = session.level();
  changing_ = session.changing();
  std::optional<std::string> failure = worker_ ? worker_->takeFailure() : std::nullopt;
  const auto time = due();
  const bool writes = time && now >= *time, rests = !changing_ || now >= lastPrepared_ + prepareSeconds;
  try {
    if (writes) {
      lastWrite_ = now;
      write(session, false);
    } else if (rests && !(prepared_ == session.level())) {
      lastPrepared_ = now;
      prepare(session);
    }
  } catch (const Error& error) {
    failure = error.what();
  }
  if (failure) kept_.reset();  // tried again in a moment
  return failure;
}

}  // namespace anamorph
