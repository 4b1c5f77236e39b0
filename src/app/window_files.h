// What a window keeps on disk besides levels: unsaved changes, recent files; and the offer to restore what an
// earlier window could not save. The GUI knows nothing of it, so screenshots and benchmarks leave no traces.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/autosave.h"
#include "app/gui.h"

namespace anamorph {

class WindowFiles {
 public:
  /// `folder`: where state is kept (state_folder.h). Offers what is found there to the GUI.
  WindowFiles(std::filesystem::path folder, Gui& gui);

  /// After every frame; `now` in seconds.
  void update(double now);
  /// When update() wants to be called though nothing happens, in seconds.
  std::optional<double> secondsUntilDue(double now) const { return autosave_.secondsUntilDue(now); }

 private:
  void answer(const RecoveryAnswer& answer);
  bool restore(Rescued& rescued);
  void keepRecent();

  std::filesystem::path folder_;
  Gui& gui_;
  Autosave autosave_;
  std::vector<Rescued> rescued_;
  std::vector<std::filesystem::path> keptLevels_, keptFolders_;
};

}  // namespace anamorph
