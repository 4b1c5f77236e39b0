// What a window keeps on disk besides levels: unsaved changes, preferences, progress, recent files; and the offer to
// restore what an earlier window could not save. No frame waits for a disk: queues write. The GUI knows nothing of it, so
// screenshots and benchmarks leave no traces.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/autosave.h"
#include "app/gui.h"
#include "app/state_folder.h"
#include "app/write_queue.h"
#include "edit/open_job.h"

namespace anamorph {

class WindowFiles {
 public:
  /// `folder`: where state is kept (state_folder.h). Offers what is found there to the GUI, and gives it the progress and
  /// the recent files; its preferences are those of the file `preferences`. `wake` is called from other threads when
  /// update() has news.
  WindowFiles(std::filesystem::path folder, std::filesystem::path preferences, Gui& gui,
              std::function<void()> wake = {});
  /// Keeps what is not kept yet.
  ~WindowFiles();
  WindowFiles(const WindowFiles&) = delete;
  WindowFiles& operator=(const WindowFiles&) = delete;

  /// After every frame; `now` in seconds of a clock that never goes back. Returns whether there is something new to be
  /// shown.
  bool update(double now);
  /// At the end: keeps what is not kept yet and waits so long for it; the files that are not written then.
  std::vector<std::filesystem::path> unwritten(double seconds);
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
  /// A value that is kept in a file.
  template <typename T>
  struct Filed {
    explicit Filed(const T& value) : asked(value), kept(std::make_shared<T>(value)) {}
    T asked;                  // that the file has, or will
    std::shared_ptr<T> kept;  // that it has; the queue's jobs have it
  };

  void answer(const RecoveryAnswer& answer, double now);
  bool restoreWhenRead(double now);
  void restore(Rescued& rescued, std::optional<LevelFile> file);
  void forget(std::size_t index);
  void stopOffering();
  void keepChanges(bool again);
  template <typename T, typename Save>
  void keep(const std::filesystem::path& file, Filed<T>& filed, const T& now, bool again, const Save& save);
  std::optional<std::string> takeNews();

  std::filesystem::path folder_, preferencesFile_;
  Gui& gui_;
  std::vector<Rescued> rescued_;
  std::string problem_;  // of what was read; not said yet
  Filed<LessonProgress> progress_;
  Filed<Preferences> preferences_;
  Filed<RecentFiles> recent_;
  std::map<std::string, std::string> failures_;  // that were said, by the files
  std::shared_ptr<Mailbox<std::string>> warnings_ = std::make_shared<Mailbox<std::string>>();
  OpenJob reading_;
  std::optional<Restoring> restoring_;
  Autosave autosave_;
  WriteQueue queue_;
};

}  // namespace anamorph
