#include "app/window_files.h"

#include <utility>

#include <fmt/format.h>

#include "app/state_folder.h"
#include "base/error.h"
#include "base/language.h"

namespace anamorph {

WindowFiles::WindowFiles(std::filesystem::path folder, Desk& desk)
    : folder_(std::move(folder)), desk_(desk), autosave_(folder_), rescued_(findRescued(folder_)) {
  UiState& ui = desk_.ui();
  for (const Rescued& rescued : rescued_) ui.recoveries.push_back(rescued.entry);
  while (ui.recoverySelected + 1 < rescued_.size() && !rescued_[ui.recoverySelected].entry.problem.empty()) {
    ++ui.recoverySelected;
  }
  loadRecent(folder_, ui);
  keptLevels_ = ui.recentLevels;
  keptFolders_ = ui.recentFolders;
}

void WindowFiles::update(double now) {
  if (const auto given = std::exchange(desk_.ui().requests.recovery, std::nullopt)) answer(*given);
  Workspace& work = desk_.work();
  for (const auto& failure : {autosave_.update(work.session, now), autosave_.keepLeft(work.leftLevels)}) {
    if (failure)
      work.message = fmt::format(fmt::runtime(tr("Unsaved changes could not be kept: {}")), *failure);
  }
  keepRecent();
}

void WindowFiles::answer(const RecoveryAnswer& answer) {
  std::vector<RecoveryEntry>& offered = desk_.ui().recoveries;
  if (answer.index >= rescued_.size()) return;
  bool more = false;
  if (answer.kind == RecoveryAnswer::Kind::discard) {
    rescued_[answer.index].remove();
    more = rescued_.size() > 1;
  } else if (answer.kind == RecoveryAnswer::Kind::restore && !restore(rescued_[answer.index])) {
    offered[answer.index].problem = desk_.work().message;
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
  Workspace& work = desk_.work();
  try {
    work.session.recover(rescued.levelPath, rescued.level, rescued.fileTime);
    lookAfresh(work);
    autosave_.writeNow(work.session);
    rescued.remove();
    work.message = tr("Restored. It is not saved yet.");
    return true;
  } catch (const Error& error) {
    work.message = error.what();
    return false;
  }
}

void WindowFiles::keepRecent() {
  UiState& ui = desk_.ui();
  if (ui.recentLevels == keptLevels_ && ui.recentFolders == keptFolders_) return;
  try {
    saveRecent(folder_, ui);
  } catch (const Error& error) {
    desk_.work().message = error.what();
  }
  keptLevels_ = ui.recentLevels;
  keptFolders_ = ui.recentFolders;
}

}  // namespace anamorph
