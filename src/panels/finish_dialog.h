// Files that are being written when the program is to end: quitting at once would cut them off.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "panels/keys.h"
#include "panels/look.h"

namespace anamorph {

/// A wish to quit that waits for files.
struct FinishQuestion {
  enum class Answer { none, wait, stop };
  Answer answer = Answer::none;  ///< wait: it quits as soon as they are written
};

/// Asks, and shows how far things are (0..1) while it waits; when it is cancelled there is no question any more.
/// `files`: that are being written.
void drawFinishDialog(std::optional<FinishQuestion>& question, const std::vector<std::string>& files,
                      double fraction, const DialogKeys& typed, const Look& look);

}  // namespace anamorph
