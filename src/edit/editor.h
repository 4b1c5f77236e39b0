// All that one window works on: the level with its history, what is made of it, how it is looked at, what is
// selected. Plain data with a few functions; no window and no ImGui, so tests and screenshots use the same.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "edit/construction.h"
#include "edit/display_settings.h"
#include "edit/edit_job.h"
#include "edit/gizmo.h"
#include "edit/lesson_state.h"
#include "edit/live_updater.h"
#include "edit/morph_stage.h"
#include "edit/open_job.h"
#include "edit/pick.h"
#include "edit/pose_flight.h"
#include "edit/save_job.h"
#include "edit/selection.h"
#include "edit/session.h"
#include "edit/status.h"
#include "edit/view_pose.h"

namespace anamorph {

enum class PreviewTab { reflection, original, difference, wipe };

struct PreviewSettings {
  PreviewTab tab = PreviewTab::reflection;
  int size = 256;     ///< longer side in pixels; 0: the pixel grid's own resolution
  double wipe = 0.5;  ///< 0..1: the reflection is shown to the left of it, the original to the right
  bool expanded = false;
};

struct Editor {
  explicit Editor(std::function<void()> wake = {}, int threads = 0)
      : updater(wake, threads), job(wake), opening(wake), saving(wake), morph(wake) {}

  Session session;
  LiveUpdater updater;
  EditJob job;      ///< an edit that is made in the background
  OpenJob opening;  ///< the level that is to come in this one's place
  SaveJob saving;   ///< the level on its way to its file

  DisplaySettings display;
  RaySettings rays;
  PreviewSettings preview;

  Selection selection;
  std::optional<PickedPoint> point;         ///< whose vertex ray is shown
  std::optional<PickedPoint> earlierPoint;  ///< that was picked before it: its ray is shown beside it
  std::optional<GridCell> cell;             ///< whose ray tree alone is shown
  GizmoMode gizmoMode = GizmoMode::move;
  bool gizmoLocal = false;

  ViewPose pose;
  std::optional<PoseFlight> flight;  ///< a move of the view that goes on
  double flightSeconds = 0;
  bool lookingThrough = false;            ///< the view is the RT camera's, and stays so when that moves
  std::optional<ViewPose> returnPose;     ///< where looking through began
  int viewWidth = 640, viewHeight = 480;  ///< of the 3D view, pixels; set by whoever shows it

  double animationSeconds = 0;  ///< of the rays
  bool animationPaused = false;
  int rayStep = 0;  ///< +1, -1: the animation is to stop where the next, the last piece of a ray ends

  /// Installed levels that were changed and left without saving, as they were left; by their canonical paths.
  std::map<std::filesystem::path, Level> leftLevels;

  MorphStage morph;
  ConstructionStage construction, earlierConstruction;

  LessonRun lesson;
  LessonProgress progress;
  int exported = 0;  ///< how many files were exported since the program started

  Status status;  ///< what the status line says of what was done last
};

/// Opens a level that was read and looks at it from where it wants to be looked at; an installed one that was left
/// changed is as it was left, unless it is the open one, which is read anew.
void openLevel(Editor& editor, LevelFile file);
/// Reads it first. Throws Error and changes nothing then.
void openLevel(Editor& editor, const std::filesystem::path& path);

/// Begins a new level, the default one, and looks at it likewise.
void openNewLevel(Editor& editor);

/// Looks at the session's level as at one that has just been opened.
void lookAfresh(Editor& editor);

/// No ray is animated or paused any more: that belongs to a level, and to a step of its lesson.
void restRays(Editor& editor);

/// Shows the vertex ray of this point, and that of the point before it; none: of no point any more. Lets go of the
/// pixel.
void pickPoint(Editor& editor, const std::optional<PickedPoint>& point);
/// Shows the rays of this cell alone, from their start, and lets go of the vertices; none: the rays of all cells.
void pickCell(Editor& editor, const std::optional<GridCell>& cell);

/// Whether something moves by itself, so that the next frame should come soon.
bool isMoving(const Editor& editor);

/// Moves the view there in a fifth of a second. Ends looking through.
void flyTo(Editor& editor, const ViewPose& pose);
/// The view is turned or shifted by hand: no flight, no looking through any more.
void takeOverView(Editor& editor);

/// The view through the RT camera.
ViewPose rtCameraPose(const Editor& editor);

/// To the RT camera's place, and back to where it began.
void toggleLookThrough(Editor& editor);

/// Of the placed original and of the sculpture as they are shown; empty when there is none.
Box originalBox(const Editor& editor);
Box sculptureBox(const Editor& editor);

/// The box of what is selected, of everything when nothing is.
Box boxOf(const Editor& editor, const Selection& selection);

/// The vertex ray of the picked point, of a frozen sculpture the one that it was made by; nothing when none is picked or
/// nothing is there yet.
const std::optional<Construction>& currentConstruction(Editor& editor);

/// The same of the point that was picked before it.
const std::optional<Construction>& earlierConstruction(Editor& editor);
/// Whether there is a sculpture to be frozen, or one that is.
bool canToggleFrozen(const Editor& editor);
/// Freezes the sculpture (level/freeze.h), or lets it follow again: one step of the history.
void toggleFrozen(Editor& editor);

/// What the 3D view shows as sculpture: the sculpture, or a state on the way to it (display.morph).
PreparedSculpture shownSculpture(Editor& editor);

}  // namespace anamorph
