// Where the program keeps what is neither a preference nor anybody's work: recent files, unsaved changes.
//
//   $XDG_STATE_HOME/anamorph, or ~/.local/state/anamorph
//     recent.json
//     recovery-<pid>.json, .lock       unsaved changes of a window, and who has them (autosave.h)
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "panels/ui_state.h"

namespace anamorph {

/// The folder, which may not exist yet.
std::filesystem::path stateFolder();

/// Recent levels and folders as they were kept; none where the file is missing or broken.
void loadRecent(const std::filesystem::path& folder, UiState& ui);

/// Keeps them, those of other windows behind these. Makes the folder. Throws Error.
void saveRecent(const std::filesystem::path& folder, UiState& ui);

}  // namespace anamorph
