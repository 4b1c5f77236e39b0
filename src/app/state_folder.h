// Where the program keeps what is neither a preference nor anybody's work: recent files, unsaved changes.
//
//   $XDG_STATE_HOME/anamorph, or ~/.local/state/anamorph
//     recent.json
//     progress.json                    what a student has done (progress_file.h)
//     recovery-<pid>.json, .lock       unsaved changes of a window, and who has them (recovery_files.h)
#pragma once

#include <filesystem>
#include <vector>

namespace anamorph {

/// The folder, which may not exist yet.
std::filesystem::path stateFolder();

/// Newest first.
struct RecentFiles {
  std::vector<std::filesystem::path> levels, folders;
  bool operator==(const RecentFiles&) const = default;
};

/// Where it keeps recent levels and folders.
std::filesystem::path recentFile(const std::filesystem::path& folder);

/// Recent levels and folders as they were kept; none where the file is missing or broken.
RecentFiles loadRecent(const std::filesystem::path& folder);

/// Keeps them, those of other windows behind these. Makes the folder. Throws Error.
void saveRecent(const std::filesystem::path& folder, RecentFiles recent);

}  // namespace anamorph
