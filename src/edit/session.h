// The level that is being looked at and edited, with its history. Every edit goes through here, whoever makes
// it: a number in a panel, the gizmo in the 3D view, a key, a script.
//
// A change is one step of the history from its first moment to finishChange(), however many frames a drag
// lasts:
//
//      change(a) change(b) change(c) finishChange()        undo()
//      |<------------- one step ---------------->|   back to before a
//
// The level as it is in its file is remembered too: it tells whether there is anything to save. Saving is no
// step: the history goes on through it, and undoing a change that was saved makes the level a modified one. Levels of the
// history share their words where those are the same (level.h); the oldest steps are forgotten when there are too many,
// or when together they take too much memory.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "level/level_json.h"

namespace anamorph {

using FileTime = std::filesystem::file_time_type;

/// When a file was written last; nothing where there is none.
std::optional<FileTime> timeOf(const std::filesystem::path& path);

/// Whether the file was written at another time than it is `known` to be: another program did it. A file that is gone has
/// not been.
bool isWrittenElsewhere(const std::filesystem::path& path, std::optional<FileTime> known);

/// A level's file as it was read.
struct LevelFile {
  std::filesystem::path path;
  LoadedLevel loaded;
  std::optional<FileTime> written;  ///< when
};

/// Reads a level, with the meshes of its mirrors, or a scene of the thesis. Throws Error, and Cancelled as readFile does.
LevelFile readLevelFile(const std::filesystem::path& path, const CancelToken* token = nullptr);

/// A level as it goes into a file.
struct SavedLevel {
  std::filesystem::path path;
  Level level;         ///< finds its mesh from there
  int generation = 0;  ///< of the session that it is of
};

class Session {
 public:
  /// Begins with what was read; a scene of the thesis gets the default box in the mesh's place.
  void open(LevelFile file);
  /// Reads it first. Throws Error and leaves everything as it was.
  void open(const std::filesystem::path& path) { open(readLevelFile(path)); }

  /// What was opened begins as `level` instead, which nobody has made: no step of the history, nothing to save.
  void beginWith(Level level);

  /// A level that has no file yet, with a history of its own.
  void startNew(Level level);
  /// What was rescued of an earlier session: the file `path` as it is on disk (a new level where there is none, or it
  /// cannot be read any more), and one step to `level`. `known`: the fileTime() of that session; a file that was
  /// written since, or cannot be read, counts as changed by another program.
  void recover(const std::filesystem::path& path, std::optional<LevelFile> file, Level level,
               std::optional<FileTime> known = std::nullopt);
  /// Saving is writing a file between two calls (SaveJob): what is to be written, after the end of a change that goes on,
  /// and what follows when it is. The level belongs to this file then, and finds its mesh from there. What was edited
  /// meanwhile stays, and is not saved; when another level has been opened meanwhile, nothing follows.
  SavedLevel prepareSave(const std::filesystem::path& path);
  void finishSave(const SavedLevel& saved, std::optional<FileTime> written);

  const Level& level() const { return level_; }
  /// As it was opened or saved last.
  const Level& saved() const { return saved_; }
  /// Empty for a new level.
  const std::filesystem::path& path() const { return path_; }
  /// Whether the file is a scene of the thesis, which a level cannot replace.
  bool isThesisScene() const { return isThesisScene_; }
  /// Whether it is one of the program's own levels, which are not written to.
  bool isInstalled() const { return isInstalled_; }
  /// When the file that was opened or saved last was written; nothing without a file.
  std::optional<FileTime> fileTime() const { return written_; }
  /// Sentences about the file that was opened.
  const std::vector<std::string>& warnings() const { return warnings_; }
  /// Grows with every level opened, so that others notice.
  int generation() const { return generation_; }

  /// The level as it is now, within a change that goes on; begins one when none does.
  void change(Level level);
  /// Ends the change that goes on, if any: one step to undo, or none when the level is what it was.
  void finishChange();
  /// Back to before the change that goes on.
  void cancelChange();
  bool changing() const { return before_.has_value(); }
  /// A whole change at once.
  void edit(Level level);

  /// What all steps, back and forth, keep in memory (history_bytes.h).
  std::size_t historyBytes() const;
  static constexpr std::size_t maxHistoryBytes = std::size_t{256} << 20;

  /// How many steps back were taken, since the program started.
  int undoCount() const { return undoCount_; }

  bool canUndo() const { return changing() || !undo_.empty(); }
  bool canRedo() const { return !changing() && !redo_.empty(); }
  /// One step back; a change that goes on is cancelled instead. Without steps nothing happens.
  void undo();
  void redo();
  /// The level as it was opened or saved last; one step to undo.
  void reset();

  /// Whether the level differs from what was opened or saved last.
  bool modified() const { return !(level_ == saved_); }

 private:
  void begin(std::filesystem::path path, Level level);
  void setPath(std::filesystem::path path);
  void remember(Level before);

  std::filesystem::path path_;
  bool isInstalled_ = false, isThesisScene_ = false;
  std::optional<FileTime> written_;  // the file, when it was opened or saved last
  Level level_, saved_;
  std::vector<std::string> warnings_;
  int generation_ = 0, undoCount_ = 0;
  std::optional<Level> before_;  // of the change that goes on
  std::vector<Level> undo_, redo_;
};

/// What the window is called: the level's title, the name of one's own file, and * when it is modified.
std::string windowTitle(const Session& session);

}  // namespace anamorph
