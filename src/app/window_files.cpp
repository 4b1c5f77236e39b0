#include "app/window_files.h"

#include <utility>

#include <fmt/format.h>

#include "app/state_folder.h"
#include "base/error.h"
#include "base/language.h"

namespace anamorph {

WindowFiles::WindowFiles(std::filesystem::path folder, Gui& gui, std::function<void()> wake)
    : folder_(std::move(folder)),
      gui_(gui),
      autosave_(folder_),
      rescued_(findRescued(folder_)),
      reading_(std::move(wake)) {
  UiState& ui = gui_.ui();
  for (const Rescued& rescued : rescued_) ui.recovery.entries.push_back(rescued.entry);
  while (ui.recovery.selected + 1 < rescued_.size() &&
         !rescued_[ui.recovery.selected].entry.problem.empty()) {
    ++ui.recovery.selected;
  }
  loadRecent(folder_, ui);
  keptLevels_ = ui.recentLevels;
  keptFolders_ = ui.browser.recentFolders;
}

void WindowFiles::update(double now) {
  if (const auto given = std::exchange(gui_.ui().requests.recovery, std::nullopt)) answer(*given, now);
  if (restoring_) restoreWhenRead(now);
  Editor& editor = gui_.editor();
  for (const auto& failure : {autosave_.update(editor.session, now), autosave_.keepLeft(editor.leftLevels)}) {
    if (failure)
      editor.message = fmt::format(fmt::runtime(tr("Unsaved changes could not be kept: {}")), *failure);
  }
  keepRecent();
}

void WindowFiles::answer(const RecoveryAnswer& answer, double now) {
  constexpr double patience = 5;  // seconds for a disk that does not answer
  using Kind = RecoveryAnswer::Kind;
  if (answer.index >= rescued_.size() || (restoring_ && answer.kind == Kind::restore)) return;
  reading_.cancel();
  restoring_.reset();
  if (answer.kind == Kind::restore) {
    restoring_ = Restoring{answer.index, now + patience};
    const std::filesystem::path& path = rescued_[answer.index].levelPath;
    if (!path.empty()) reading_.start(path);
    return;
  }
  if (answer.kind == Kind::discard) {
    rescued_[answer.index].remove();
    forget(answer.index);
    if (!rescued_.empty()) return;
  }
  stopOffering();
}

void WindowFiles::restoreWhenRead(double now) {
  std::optional<LevelFile> file;
  try {
    file = reading_.take();
  } catch (const Error&) {
    // The level that was rescued needs no file.
  }
  if (reading_.busy() && now < restoring_->until) return;
  reading_.cancel();
  const std::size_t index = std::exchange(restoring_, std::nullopt)->index;
  if (!restore(rescued_[index], std::move(file))) {
    gui_.ui().recovery.entries[index].problem = gui_.editor().message;
    return;
  }
  forget(index);
  stopOffering();
}

void WindowFiles::forget(std::size_t index) {
  std::vector<RecoveryEntry>& offered = gui_.ui().recovery.entries;
  rescued_.erase(rescued_.begin() + static_cast<std::ptrdiff_t>(index));
  offered.erase(offered.begin() + static_cast<std::ptrdiff_t>(index));
}

// What is left stays where it is, for the next start: a second one would replace what was just restored.
void WindowFiles::stopOffering() {
  rescued_.clear();
  gui_.ui().recovery.entries.clear();
}

// It is kept anew before the old file goes.
bool WindowFiles::restore(Rescued& rescued, std::optional<LevelFile> file) {
  Editor& editor = gui_.editor();
  try {
    editor.session.recover(rescued.levelPath, std::move(file), rescued.level, rescued.fileTime);
    lookAfresh(editor);
    autosave_.writeNow(editor.session);
    rescued.remove();
    editor.message = tr("Restored. It is not saved yet.");
    return true;
  } catch (const Error& error) {
    editor.message = error.what();
    return false;
  }
}

void WindowFiles::keepRecent() {
  UiState& ui = gui_.ui();
  if (ui.recentLevels == keptLevels_ && ui.browser.recentFolders == keptFolders_) return;
  try {
    saveRecent(folder_, ui);
  } catch (const Error& error) {
    gui_.editor().message = error.what();
  }
  keptLevels_ = ui.recentLevels;
  keptFolders_ = ui.browser.recentFolders;
}

}  // namespace anamorph
