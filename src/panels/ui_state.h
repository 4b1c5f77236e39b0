// What the panels remember between frames, what they are given to show, and what they ask of the window.
// Plain data.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "edit/gizmo_drag.h"
#include "edit/lesson_run.h"
#include "edit/pick.h"
#include "edit/selection.h"
#include "exports/export_request.h"
#include "level/level_library.h"
#include "panels/file_browser.h"
#include "panels/layout.h"

struct ImFont;

namespace anamorph {

/// The fonts that the window has loaded; null: Dear ImGui's own.
struct Fonts {
  ImFont* text = nullptr;
  ImFont* strong = nullptr;
  ImFont* title = nullptr;
  ImFont* huge = nullptr;  ///< for an audience; loaded while presenting
};

enum class Theme { dark, light, projector };

/// A language that can be chosen: its code ("nl"), and what its speakers call it.
struct LanguageChoice {
  std::string code, name;
};

constexpr std::size_t maxRecentLevels = 10, maxRecentFolders = 6;

/// Kept between runs.
struct Preferences {
  Theme theme = Theme::dark;
  double uiScale = 0;    ///< 0: as the screen says; else 0.75..3
  bool vrtKeys = false;  ///< T/R/S for move, rotate, scale as in Virtual Ray Tracer, instead of W/E/R
  bool legend = true;
  bool tourSeen = false;
  double leftWidth = 264, rightWidth = 336, previewHeight = 416;  ///< at 100 % UI scale
  std::string language;                                           ///< code; empty: as the system is set

  bool operator==(const Preferences&) const = default;
};

/// A picture on the graphics card; id 0: none.
struct UiTexture {
  std::uint32_t id = 0;
  int width = 0, height = 0;
  bool bottomUp = false;  ///< its first row is the lowest, as OpenGL draws
};

struct UiTextures {
  UiTexture view;
  UiTexture reflection, original, difference;
  UiTexture render;                             ///< the high-resolution picture
  std::map<std::string, UiTexture> thumbnails;  ///< by the level's name
};

/// What is to become of something that was rescued of a session that ended badly.
struct RecoveryAnswer {
  enum class Kind { restore, discard, later };
  Kind kind = Kind::later;
  std::size_t index = 0;  ///< of the entry
};

/// A level that an earlier session could not save.
struct RecoveryEntry {
  std::filesystem::path level;  ///< its file; empty for one that had none
  std::string title, time;
  std::string problem;  ///< why it cannot be restored; empty: it can
};

/// What waits for an answer because there are unsaved changes.
struct UnsavedQuestion {
  enum class Next { open, startNew, quit };
  enum class Answer { none, save, drop };
  Next next = Next::open;
  std::filesystem::path path;    ///< to open
  Answer answer = Answer::none;  ///< save: it goes on as soon as the level is saved
};

/// Something that did not work and must not be overlooked.
struct Notice {
  std::string title;  ///< English
  std::string text;
};

/// A key that was pressed while a dialog was open.
struct DialogKey {
  int key = 0;
  bool repeated = false;  ///< it is held down
};

/// A picture of the window.
struct ShotRequest {
  int factor = 1;  ///< times as large as the window, 1..4
  bool panels = true;
  bool transparent = false;
  std::filesystem::path path;  ///< empty: one is found beside the user's other pictures
};

/// What only the window can do; taken and cleared by it after every frame.
struct UiRequests {
  bool quit = false;
  bool toggleFullscreen = false;
  std::optional<ShotRequest> shot;
  bool startExport = false, cancelExport = false, checkPrint = false;
  bool startRender = false, cancelRender = false;
  std::optional<std::filesystem::path> saveRender;
  std::optional<std::filesystem::path> open;  ///< a level; asked about first when there are unsaved changes
  bool startNew = false;                      ///< likewise
  std::optional<RecoveryAnswer> recovery;
};

/// The window that exports.
struct ExportDialog {
  bool open = false;
  int kind = 0;  ///< which one of exportEntries() (export_entries.h)
  ExportRequest request;
  ShotRequest shot;
  bool saveAsked = false;        ///< by the key Enter
  std::filesystem::path folder;  ///< of the last export; empty: none yet
  bool choosing = false;         ///< the file browser is open for it
  bool running = false;
  double fraction = 0;
  std::string message;                                    ///< what came of the last one
  std::vector<std::string> lines;                         ///< and what else is to be said about it
  std::vector<std::pair<std::string, std::string>> rows;  ///< figures, in two columns

  /// In place of what was said before.
  void say(std::string text, std::vector<std::string> more = {},
           std::vector<std::pair<std::string, std::string>> figures = {}) {
    message = std::move(text);
    lines = std::move(more);
    rows = std::move(figures);
  }
};

enum class PropertyTab { eye, original, mirror, sculpture, lights, rays, view };

/// The window with the high-resolution picture.
struct RenderDialog {
  bool open = false;
  int longerSide = 1024;
  int samplesPerAxis = 3;
  bool running = false;
  double fraction = 0;
  float zoom = 1;
  float panX = 0, panY = 0;
  std::filesystem::path folder;  ///< of the last picture saved; empty: none yet
  bool choosing = false;         ///< the file browser is open for it
  std::string message;
};

/// A step of a level that was opened: the session's generation, and its number.
using StepOfLesson = std::pair<int, std::size_t>;
inline StepOfLesson openStepOf(const LessonRun& run) {
  return {run.generation, run.step};
}

/// A drag in the 3D view that goes on.
enum class ViewDrag { none, orbit, pan, gizmo };

struct UiState {
  Preferences preferences;
  Fonts fonts;
  double scale = 1;  ///< of everything, from the preferences or the screen
  Layout layout;
  UiTextures textures;
  UiRequests requests;
  std::vector<LevelEntry> levels;
  std::vector<LanguageChoice> languages;

  FileBrowser browser;
  std::optional<UnsavedQuestion> unsaved;
  std::optional<Notice> notice;
  std::vector<RecoveryEntry> recoveries;  ///< that are offered
  std::size_t recoverySelected = 0;
  std::vector<DialogKey> dialogKeys;                               ///< since the last frame
  std::vector<std::filesystem::path> recentLevels, recentFolders;  ///< newest first

  std::string keyPanel;  ///< the window that has the keyboard (panels/key_focus.h); empty: the 3D view
  bool keyPanelEntered = false;  ///< it is to get it in this frame
  bool panelsHidden = false;
  bool helpOpen = false;
  bool progressOpen = false;
  bool resetAsked = false;      ///< whether progress is really to be forgotten
  bool presenting = false;      ///< the open step in large letters
  int tourCard = -1;            ///< of the tour; -1: it is not shown
  double tourSeconds = 0;       ///< since its card appeared
  std::string highlight;        ///< English name of the control that "show me" points at
  double highlightSeconds = 0;  ///< that are left of it
  StepOfLesson highlightStep;   ///< that it belongs to
  int noticeFrames = 0;         ///< for which the open step's notice is still to be scrolled to
  bool wasDone = false;         ///< the open step, in the last frame
  StepOfLesson scrolledStep;    ///< that the lesson's text has been scrolled to the top for
  RenderDialog render;
  ExportDialog exporting;

  PropertyTab tab = PropertyTab::eye;
  Selection tabSelection;  ///< that `tab` was last switched for

  ViewDrag viewDrag = ViewDrag::none;
  std::optional<GizmoDrag> gizmoDrag;
  std::optional<GizmoHandle> hoveredHandle;
  std::optional<GridCell> hoveredCell;  ///< in the preview
  bool clickPending = false;            ///< the mouse went down on nothing and has not moved yet
  int axisLock = -1;                    ///< 0..2 while x, y or z is locked

  double frameMilliseconds = 0;  ///< of the last drawn frame, for the status line
  double viewScale = 1;          ///< of the 3D view's picture
  int viewSamples = 0;
  bool bare = false;      ///< a picture of the things alone: without legend and axes
  bool headless = false;  ///< a screenshot: nothing that differs from run to run is shown
};

}  // namespace anamorph
