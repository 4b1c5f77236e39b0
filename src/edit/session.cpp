#include "edit/session.h"

#include <utility>

#include "level/level_json.h"

namespace anamorph {
namespace {

constexpr std::size_t maxSteps = 1000;

// A scene of the thesis says where the mesh stands, but not which: the thesis' box does.
void fillScene(Level& level) {
  level.original.shape = BoxShape{};
  level.camera.target = level.original.placement.position;
}

}  // namespace

void Session::open(const std::filesystem::path& path) {
  LoadedLevel loaded = loadLevel(path);
  if (loaded.isThesisScene) fillScene(loaded.level);
  path_ = path;
  warnings_ = std::move(loaded.warnings);
  level_ = std::move(loaded.level);
  opened_ = level_;
  before_.reset();
  undo_.clear();
  redo_.clear();
  ++generation_;
}

void Session::change(Level level) {
  if (!before_) before_ = level_;
  level_ = std::move(level);
}

void Session::finishChange() {
  if (!before_) return;
  Level before = *std::exchange(before_, std::nullopt);
  if (before == level_) return;
  if (undo_.size() == maxSteps) undo_.erase(undo_.begin());
  undo_.push_back(std::move(before));
  redo_.clear();
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
  edit(opened_);
}

}  // namespace anamorph
