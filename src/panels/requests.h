// What panels ask of the window, because only it can do it: files, other threads, the screen.
#pragma once

#include <filesystem>
#include <optional>

#include "panels/recovery_dialog.h"

namespace anamorph {

/// A picture of the window.
struct ShotRequest {
  int factor = 1;  ///< times as large as the window, 1..4
  bool panels = true;
  bool transparent = false;
  std::filesystem::path path;  ///< empty: one is found beside the user's other pictures
};

/// Taken and cleared by the GUI or the window after every frame.
/// A level that is to be saved as soon as the one that is being written is.
struct SaveWish {
  std::filesystem::path path;
  bool mayReplace = false;  ///< also what another program wrote there
  int generation = 0;       ///< of the session that it is of
};

struct UiRequests {
  bool quit = false;
  bool toggleFullscreen = false;
  std::optional<ShotRequest> shot;
  bool cancelShot = false;
  bool startExport = false, cancelExport = false, checkPrint = false;
  bool startRender = false, cancelRender = false;
  std::optional<std::filesystem::path> saveRender;
  std::optional<std::filesystem::path> open;  ///< a level; asked about first when there are unsaved changes
  bool startNew = false;                      ///< likewise
  std::optional<RecoveryAnswer> recovery;
};

}  // namespace anamorph
