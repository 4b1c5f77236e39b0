// What a window keeps on disk besides levels: unsaved changes, recent files; and the offer to restore what an
// earlier window could not save. The GUI knows nothing of it, so screenshots and benchmarks leave no traces.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "app/autosave.h"
#include "app/gui.h"
#include "edit/open_job.h"

namespace anamorph {

class WindowFiles {
 public:
  /// `folder`: where state is kept (state_folder.h). Offers what is found there to the GUI.
  WindowFiles(std::filesystem::path folder, Gui& gui, std::function<void()> wake);

  /// After every frame; `now` in seconds.
  void update(double now);
  /// When update() wants to be called though nothing happens, in seconds.
  std::optional<double> secondsUntilDue(double now) const {
    return restoring_ ? std::optional(0.1) : autosave_.secondsUntilDue(now);
  }

 private:
  /// Whose level's file is being read before.
  struct Restoring {
    std::size_t index;
    double until;  ///< then it is done without
  };
  void answer(const RecoveryAnswer& answer, double now);
  void restoreWhenRead(double now);
  bool restore(Rescued& rescued, std::optional<LevelFile> file);
  void forget(std::size_t index);
  void stopOffering();
  void keepRecent();

  std::filesystem::path folder_;
  Gui& gui_;
  Autosave autosave_;
  std::vector<Rescued> rescued_;
  OpenJob reading_;
  std::optional<Restoring> restoring_;
  std::vector<std::filesystem::path> keptLevels_, keptFolders_;
};

}  // namespace anamorph
