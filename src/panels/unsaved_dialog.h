// What is to become of changes that are not saved, before the level is left.
#pragma once

#include <filesystem>
#include <optional>

#include "edit/editor.h"
#include "panels/keys.h"
#include "panels/look.h"

namespace anamorph {

/// What waits for an answer because there are unsaved changes.
struct UnsavedQuestion {
  enum class Next { open, startNew, quit };
  enum class Answer { none, save, drop };
  Next next = Next::open;
  std::filesystem::path path;    ///< to open
  Answer answer = Answer::none;  ///< save: it goes on as soon as the level is saved
};

/// Asks until there is an answer; when it is cancelled there is no question any more. Returns whether the level is to
/// be saved now.
bool drawUnsavedDialog(const Editor& editor, std::optional<UnsavedQuestion>& question,
                       const DialogKeys& typed, const Look& look);

}  // namespace anamorph
