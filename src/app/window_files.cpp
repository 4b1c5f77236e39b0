#include "app/window_files.h"

#include <utility>

#include <imgui.h>

#include "app/preferences.h"
#include "app/progress_file.h"
#include "base/error.h"
#include "base/language.h"
#include "pipeline/mirror_files.h"

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
      reading_(wake),
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
  if (const auto given = std::exchange(gui_.ui().requests.recovery, std::nullopt)) answer(*given, now);
  const bool restored = restoring_ && restoreWhenRead(now);
  Editor& editor = gui_.editor();
  if (!ImGui::IsAnyMouseDown()) keepChanges(false);
  const std::optional<std::string> news = takeNews(),
                                   unkept = autosave_.update(editor.session, editor.leftLevels, now);
  if (news || unkept) editor.status.say(unkept ? *unkept : *news);
  return restored || news || unkept;
}

std::vector<std::filesystem::path> WindowFiles::unwritten(double seconds) {
  keepChanges(true);
  const std::vector<std::string> files = queue_.undone(seconds);
  return {files.begin(), files.end()};
}

void WindowFiles::answer(const RecoveryAnswer& answer, double now) {
  constexpr double patience = 5;  // seconds for a disk that does not answer
  using Kind = RecoveryAnswer::Kind;
  if (answer.index >= rescued_.size() || (restoring_ && answer.kind == Kind::restore)) return;
  reading_.cancel();
  restoring_.reset();
  if (answer.kind == Kind::restore) {
    restoring_ = Restoring{answer.index, now + patience};
    const std::filesystem::path& path = rescued_[answer.index].path;
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

// Returns whether it was done.
bool WindowFiles::restoreWhenRead(double now) {
  std::optional<LevelFile> file;
  try {
    file = reading_.take();
  } catch (const Error&) {
    // The level that was rescued needs no file.
  }
  if (reading_.busy() && now < restoring_->until) return false;
  reading_.cancel();
  restore(rescued_[std::exchange(restoring_, std::nullopt)->index], std::move(file));
  stopOffering();
  return true;
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

// What it was rescued from is what it is kept in from now on.
void WindowFiles::restore(Rescued& rescued, std::optional<LevelFile> file) {
  Editor& editor = gui_.editor();
  if (takeMirrorFiles(rescued.level, file ? file->loaded.level : Level()))
    readMirrorFiles(rescued.level, rescued.path);
  editor.session.recover(rescued.path, std::move(file), rescued.level, rescued.fileTime);
  lookAfresh(editor);
  autosave_.adopt(std::move(rescued));
  editor.status.sayOf(editor.session.level(), tr("Restored. It is not saved yet."));
}

// `again`: what has failed before is tried once more.
void WindowFiles::keepChanges(bool again) {
  const UiState& ui = gui_.ui();
  keep(preferencesFile_, preferences_, ui.preferences, again, savePreferences);
  keep(progressFile(folder_), progress_, gui_.editor().progress, again, saveProgress);
  keep(recentFile(folder_), recent_, recentOf(ui), again,
       [folder = folder_](const auto&, const RecentFiles&, const RecentFiles& now) {
         saveRecent(folder, now);
         return std::vector<std::string>();
       });
}

template <typename T, typename Save>
void WindowFiles::keep(const std::filesystem::path& file, Filed<T>& filed, const T& now, bool again,
                       const Save& save) {
  const bool failed = !failures_[file.string()].empty();
  if (filed.asked == now && !(again && failed)) return;
  filed.asked = now;
  queue_.add(file.string(), [file, kept = filed.kept, now, save, warnings = warnings_] {
    if (*kept == now) return;
    for (const std::string& warning : save(file, *kept, now)) warnings->put(warning);
    *kept = now;
  });
}

// Failures once for each reason: it is tried again with the next change, and may fail again.
std::optional<std::string> WindowFiles::takeNews() {
  std::optional<std::string> news = warnings_->take();
  for (const WriteQueue::Outcome& outcome : queue_.takeOutcomes()) {
    std::string& said = failures_[outcome.name];
    if (!outcome.failure.empty() && outcome.failure != said) news = outcome.failure;
    said = outcome.failure;
  }
  if (!problem_.empty()) news = std::exchange(problem_, "");
  return news;
}

}  // namespace anamorph
