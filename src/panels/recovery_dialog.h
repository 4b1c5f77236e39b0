// Levels that an earlier session could not save any more, offered when the program starts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "panels/keys.h"
#include "panels/look.h"

namespace anamorph {

/// A level that an earlier session could not save.
struct RecoveryEntry {
  std::filesystem::path level;  ///< its file; empty for one that had none
  std::string title, time;
  std::string problem;       ///< why it cannot be restored; empty: it can
  bool fileIsNewer = false;  ///< the level's file was written after this was kept
};

/// What is to become of something that was rescued of a session that ended badly.
struct RecoveryAnswer {
  enum class Kind { restore, discard, later };
  Kind kind = Kind::later;
  std::size_t index = 0;  ///< of the entry
};

struct RecoveryDialog {
  std::vector<RecoveryEntry> entries;  ///< that are offered; the dialog is open while there are any
  std::size_t selected = 0;
};

/// Returns the answer when one was given.
std::optional<RecoveryAnswer> drawRecoveryDialog(RecoveryDialog& dialog, const DialogKeys& typed,
                                                 const Look& look);

}  // namespace anamorph
