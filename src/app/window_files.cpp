#include "app/window_files.h"

#include <utility>

#include <imgui.h>

#include "app/preferences.h"
#include "app/progress_file.h"
#include "base/language.h"

namespace anamorph {
namespace {

RecentFiles recentOf(const UiState& ui) {
  return {ui.recentLevels, ui.browser.recentFolders};
}

std::filesystem::path progressFile(const std::filesystem::path& folder) {
  return folder / "progress.json";
}

}  // namespace

WindowFiles::WindowFiles(std::filesystem::path folder, std::filesystem::path preferences, Gui& gui,
                         std::function<void()> wake)
    : folder_(std::move(folder)),
      preferencesFile_(std::move(preferences)),
      gui_(gui),
      rescued_(findRescued(folder_)),
      progress_(loadProgress(progressFile(folder_), problem_)),
      preferences_(gui.ui().preferences),
      recent_(loadRecent(folder_)),
      autosave_(folder_, wake),
      queue_(wake) {
  UiState& ui = gui_.ui();
  for (const Rescued& rescued : rescued_) ui.recovery.entries.push_back(rescued.entry);
  while (ui.recovery.selected + 1 < rescued_.size() &&
         !rescued_[ui.recovery.selected].entry.problem.empty()) {
    ++ui.recovery.selected;
  }
  gui_.editor().progress = progress_.asked;
  ui.recentLevels = recent_.asked.levels;
  ui.browser.recentFolders = recent_.asked.folders;
}

WindowFiles::~WindowFiles() {
  keepChanges(true);
}

bool WindowFiles::update(double now) {
  if (const auto given = std::exchange(gui_.ui().requests.recovery, std::nullopt)) answer(*given);
  Editor& editor = gui_.editor();
  if (!ImGui::IsAnyMouseDown()) keepChanges(false);
  const std::optional<std::string> failure = takeFailure(),
                                   news = autosave_.update(editor.session, editor.leftLevels, now);
  if (news || failure) editor.message = news ? *news : *failure;
  return news || failure;
}

void WindowFiles::answer(const RecoveryAnswer& answer) {
  std::vector<RecoveryEntry>& offered = gui_.ui().recovery.entries;
  if (answer.index >= rescued_.size()) return;
  const bool discards = answer.kind == RecoveryAnswer::Kind::discard, more = discards && rescued_.size() > 1;
  if (discards) rescued_[answer.index].remove();
  if (answer.kind == RecoveryAnswer::Kind::restore) restore(rescued_[answer.index]);
  if (answer.kind != RecoveryAnswer::Kind::later) {
    rescued_.erase(rescued_.begin() + static_cast<std::ptrdiff_t>(answer.index));
    offered.erase(offered.begin() + static_cast<std::ptrdiff_t>(answer.index));
  }
  if (more) return;
  // The others stay where they are, for the next start: a second one would replace what was just restored.
  rescued_.clear();
  offered.clear();
}

// What it was rescued from is what it is kept in from now on.
void WindowFiles::restore(Rescued& rescued) {
  Editor& editor = gui_.editor();
  editor.session.recover(rescued.path, rescued.level, rescued.fileTime);
  lookAfresh(editor);
  autosave_.adopt(std::move(rescued));
  editor.message = tr("Restored. It is not saved yet.");
}

// `again`: what has failed before is tried once more.
void WindowFiles::keepChanges(bool again) {
  const UiState& ui = gui_.ui();
  keep("preferences", preferences_, ui.preferences, again,
       [path = preferencesFile_](const Preferences& before, const Preferences& now) {
         savePreferences(path, before, now);
       });
  keep("progress", progress_, gui_.editor().progress, again,
       [path = progressFile(folder_)](const LessonProgress& before, const LessonProgress& now) {
         saveProgress(path, before, now);
       });
  keep("recent files", recent_, recentOf(ui), again,
       [folder = folder_](const RecentFiles&, const RecentFiles& now) { saveRecent(folder, now); });
}

template <typename T, typename Save>
void WindowFiles::keep(const char* name, Filed<T>& filed, const T& now, bool again, const Save& save) {
  if (filed.asked == now && !again) return;
  filed.asked = now;
  queue_.add(name, [kept = filed.kept, now, save] {
    if (*kept == now) return;
    save(*kept, now);
    *kept = now;
  });
}

// Once for each reason: it is tried again with the next change, and may fail again.
std::optional<std::string> WindowFiles::takeFailure() {
  std::optional<std::string> news;
  for (const WriteQueue::Outcome& outcome : queue_.takeOutcomes()) {
    std::string& said = failures_[outcome.name];
    if (!outcome.failure.empty() && outcome.failure != said) news = outcome.failure;
    said = outcome.failure;
  }
  if (!problem_.empty()) news = std::exchange(problem_, "");
  return news;
}

}  // namespace anamorph
