#include "app/window_files.h"

#include <utility>

#include <fmt/format.h>

#include "app/state_folder.h"
#include "base/error.h"
#include "base/language.h"

namespace anamorph {

WindowFiles::WindowFiles(std::filesystem::path folder, Gui& gui)
    : folder_(std::move(folder)), gui_(gui), autosave_(folder_), rescued_(findRescued(folder_)) {
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
  if (const auto given = std::exchange(gui_.ui().requests.recovery, std::nullopt)) answer(*given);
  Editor& editor = gui_.editor();
  for (const auto& failure : {autosave_.update(editor.session, now), autosave_.keepLeft(editor.leftLevels)}) {
    if (failure) editor.message = trFormat("Unsaved changes could not be kept: {}", *failure);
  }
  keepRecent();
}

void WindowFiles::answer(const RecoveryAnswer& answer) {
  std::vector<RecoveryEntry>& offered = gui_.ui().recovery.entries;
  if (answer.index >= rescued_.size()) return;
  bool more = false;
  if (answer.kind == RecoveryAnswer::Kind::discard) {
    rescued_[answer.index].remove();
    more = rescued_.size() > 1;
  } else if (answer.kind == RecoveryAnswer::Kind::restore && !restore(rescued_[answer.index])) {
    offered[answer.index].problem = gui_.editor().message;
    return;
  }
  if (answer.kind != RecoveryAnswer::Kind::later) {
    rescued_.erase(rescued_.begin() + static_cast<std::ptrdiff_t>(answer.index));
    offered.erase(offered.begin() + static_cast<std::ptrdiff_t>(answer.index));
  }
  if (more) return;
  // The others stay where they are, for the next start: a second one would replace what was just restored.
  rescued_.clear();
  offered.clear();
}

// It is kept anew before the old file goes.
bool WindowFiles::restore(Rescued& rescued) {
  Editor& editor = gui_.editor();
  try {
    editor.session.recover(rescued.levelPath, rescued.level, rescued.fileTime);
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
