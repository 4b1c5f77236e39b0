#include "edit/session.h"

#include <algorithm>
#include <cstddef>
#include <system_error>
#include <utility>

#include "base/error.h"
#include "base/language.h"
#include "base/text.h"
#include "edit/history_bytes.h"
#include "edit/level_files.h"
#include "level/level_json.h"
#include "pipeline/mirror_files.h"

namespace anamorph {
namespace {

constexpr std::size_t maxSteps = 1000;

// A scene of the thesis says where the mesh stands, but not which: the thesis' box does.
void fillScene(Level& level) {
  level.original.shape = BoxShape{};
  level.camera.target = level.original.placement.position;
}

}  // namespace

std::optional<FileTime> timeOf(const std::filesystem::path& path) {
  std::error_code failure;
  const bool isFile = std::filesystem::is_regular_file(path, failure);
  const auto time = isFile ? std::filesystem::last_write_time(path, failure) : FileTime();
  return !isFile || failure ? std::nullopt : std::optional(time);
}

bool isWrittenElsewhere(const std::filesystem::path& path, std::optional<FileTime> known) {
  const auto now = timeOf(path);
  return now && known && *now != *known;
}

LevelFile readLevelFile(const std::filesystem::path& path, const CancelToken* token) {
  const auto written = timeOf(path);
  LevelFile file{path, loadLevel(path, token), written};
  for (std::string& warning : readMirrorFiles(file.loaded.level, path, {}, token))
    file.loaded.warnings.push_back(std::move(warning));
  return file;
}

void Session::open(LevelFile file) {
  LoadedLevel& loaded = file.loaded;
  if (loaded.isThesisScene) fillScene(loaded.level);
  begin(std::move(file.path), std::move(loaded.level));
  isThesisScene_ = loaded.isThesisScene;
  written_ = file.written;
  warnings_ = std::move(loaded.warnings);
}

void Session::begin(std::filesystem::path path, Level level) {
  setPath(std::move(path));
  written_.reset();
  warnings_.clear();
  level_ = std::move(level);
  saved_ = level_;
  before_.reset();
  undo_.clear();
  redo_.clear();
  ++generation_;
}

void Session::setPath(std::filesystem::path path) {
  path_ = std::move(path);
  isInstalled_ = !path_.empty() && isInstalledLevel(path_);
  isThesisScene_ = false;
}

void Session::beginWith(Level level) {
  before_.reset();
  undo_.clear();
  redo_.clear();
  level_ = saved_ = std::move(level);
}

void Session::startNew(Level level) {
  begin({}, std::move(level));
}

void Session::recover(const std::filesystem::path& path, std::optional<LevelFile> file, Level level,
                      std::optional<std::filesystem::file_time_type> known) {
  if (file) {
    open(std::move(*file));
    if (written_ && known) written_ = known;
  } else {
    begin(path, Level());
    written_ = std::filesystem::file_time_type::min();
  }
  edit(std::move(level));
}

SavedLevel Session::prepareSave(const std::filesystem::path& path) {
  finishChange();
  return {path, withMeshFrom(level_, path_, path), generation_};
}

void Session::finishSave(const SavedLevel& saved, std::optional<FileTime> written) {
  if (saved.generation != generation_) return;
  const auto move = [&](Level& level) { level = withMeshFrom(std::move(level), path_, saved.path); };
  for (Level& step : undo_) move(step);
  for (Level& step : redo_) move(step);
  if (before_) move(*before_);
  move(level_);
  saved_ = saved.level;
  setPath(saved.path);
  written_ = written;
}

void Session::change(Level level) {
  if (!before_) before_ = level_;
  level_ = std::move(level);
}

void Session::finishChange() {
  if (!before_) return;
  Level before = *std::exchange(before_, std::nullopt);
  if (before == level_) return;
  redo_.clear();
  remember(std::move(before));
}

void Session::remember(Level before) {
  dropCutSurfaces(before);
  undo_.push_back(std::move(before));
  shareText(level_, undo_);
  const std::size_t kept = std::min(maxSteps, countWithin(undo_, maxHistoryBytes));
  undo_.erase(undo_.begin(), undo_.end() - static_cast<std::ptrdiff_t>(kept));
}

std::size_t Session::historyBytes() const {
  std::vector<Level> all = undo_;
  all.insert(all.end(), redo_.begin(), redo_.end());
  return bytesOf(all);
}

void Session::cancelChange() {
  if (before_) level_ = *std::exchange(before_, std::nullopt);
}

void Session::edit(Level level) {
  finishChange();
  change(std::move(level));
  finishChange();
}

void Session::undo() {
  if (changing()) return cancelChange();
  if (undo_.empty()) return;
  ++undoCount_;
  redo_.push_back(std::exchange(level_, std::move(undo_.back())));
  undo_.pop_back();
}

void Session::redo() {
  if (!canRedo()) return;
  undo_.push_back(std::exchange(level_, std::move(redo_.back())));
  redo_.pop_back();
}

void Session::reset() {
  edit(saved_);
}

std::string windowTitle(const Session& session) {
  const std::filesystem::path& path = session.path();
  std::string title = shortened(tr(session.level().text->title), 300);
  if (!path.empty() && !session.isInstalled()) {
    const std::string file = path.filename().string();
    title = title.empty() ? file : title + " (" + file + ")";
  }
  if (title.empty()) title = tr("Untitled");
  return title + (session.modified() ? " * - Anamorph" : " - Anamorph");
}

}  // namespace anamorph
