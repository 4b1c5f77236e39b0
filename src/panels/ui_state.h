// What the panels remember between frames, what they are given to show, and what they ask of the window: put
// together of what the single windows remember. Plain data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "edit/level_repairs.h"
#include "edit/pick.h"
#include "level/languages.h"
#include "level/level_library.h"
#include "panels/browser_state.h"
#include "panels/export_window.h"
#include "panels/finish_dialog.h"
#include "panels/highlight.h"
#include "panels/key_focus.h"
#include "panels/keys.h"
#include "panels/layout.h"
#include "panels/lesson_scroll.h"
#include "panels/long_text.h"
#include "panels/look.h"
#include "panels/mesh_dialog.h"
#include "panels/notice_dialog.h"
#include "panels/preferences.h"
#include "panels/progress_window.h"
#include "panels/property_tabs.h"
#include "panels/recovery_dialog.h"
#include "panels/render_window.h"
#include "panels/requests.h"
#include "panels/textures.h"
#include "panels/tour.h"
#include "panels/unsaved_dialog.h"
#include "panels/view_mouse.h"

namespace anamorph {

constexpr std::size_t maxRecentLevels = 10;

struct UiState : Look {
  // Given to be shown.
  Preferences preferences;  ///< are changed here, too
  Layout layout;
  UiTextures textures;
  std::vector<LevelEntry> levels;
  std::vector<LanguageChoice> languages;
  bool preparingView = false;    ///< the 3D view is of an earlier time until its shaders are compiled
  std::string viewProblem;       ///< what of the level the 3D view cannot show; empty: it shows all
  double frameMilliseconds = 0;  ///< of the last drawn frame, for the status line
  bool bare = false;             ///< a picture of the things alone: without legend and axes
  bool headless = false;         ///< a screenshot: nothing that differs from run to run is shown

  UiRequests requests;
  std::optional<SaveWish> saveNext;
  struct ShotProgress {
    bool running = false;  ///< until it is written
    bool drawing = false;
    double fraction = 0;
    std::string file;  ///< where the user wants it; empty: anywhere
  } shot;              ///< the picture of the window that is being made

  // Dialogs, of which one has all keys (panels/dialogs.h).
  std::optional<Notice> notice;
  FileBrowser browser;
  std::optional<UnsavedQuestion> unsaved;
  std::optional<FinishQuestion> finish;
  std::optional<MeshQuestion> meshQuestion;
  RecoveryDialog recovery;
  DialogKeys dialogKeys;                            ///< since the last frame
  std::vector<std::filesystem::path> recentLevels;  ///< newest first; kept between runs

  // Windows over the panels.
  ExportDialog exporting;
  RenderDialog render;
  ProgressWindow progress;
  Tour tour;
  bool helpOpen = false;
  bool presenting = false;  ///< the open step in large letters

  // The panels themselves.
  bool panelsHidden = false;
  bool levelsOpen = false;  ///< the level list, which is folded while a lesson needs its room
  KeyFocus keyFocus;
  Highlight highlight;
  LessonScroll lessonScroll;
  LongTexts longTexts;
  PropertyTabs tabs;
  Rect tabsArea;                        ///< where they were drawn last
  ViewMouse mouse;                      ///< in the 3D view
  std::optional<GridCell> hoveredCell;  ///< in the preview
  RepairsStage repairs;                 ///< of a level that cannot be shown
};

}  // namespace anamorph
