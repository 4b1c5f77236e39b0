#include "panels/actions.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>

#include "edit/lesson_run.h"
#include "edit/orbit.h"
#include "panels/file_flow.h"
#include "panels/key_focus.h"
#include "panels/lesson_text.h"
#include "panels/let_go.h"
#include "panels/level_sharing.h"
#include "panels/tour.h"
#include "panels/view_mouse.h"
#include "panels/widgets.h"
#include "panels/windows.h"

namespace anamorph {
namespace {

// The level so many places after the one that is open; the last and the first are followed by nothing.
const LevelEntry* neighbour(const Editor& editor, const UiState& ui, int offset) {
  const auto current = std::find_if(ui.levels.begin(), ui.levels.end(),
                                    [&](const LevelEntry& entry) { return isOpen(editor, entry); });
  const auto index = current - ui.levels.begin() + offset;
  if (current == ui.levels.end() || index < 0 || index >= static_cast<std::ptrdiff_t>(ui.levels.size()))
    return nullptr;
  return &ui.levels[static_cast<std::size_t>(index)];
}

template <int offset>
bool hasNeighbour(const Editor& editor, const UiState& ui) {
  return neighbour(editor, ui, offset) != nullptr;
}

template <int offset>
void openNeighbour(Editor& editor, UiState& ui) {
  ui.requests.open = neighbour(editor, ui, offset)->path;
}

// The gizmo of the original is to be seen, which a construction hides.
template <GizmoMode mode>
void setMode(Editor& editor, UiState&) {
  editor.gizmoMode = mode;
  if (editor.selection.part == Part::original) pickPoint(editor, {});
}

template <GizmoMode mode>
bool hasMode(const Editor& editor, const UiState&) {
  return editor.gizmoMode == mode;
}

template <ViewSide side>
void flyToSide(Editor& editor, UiState&) {
  flyTo(editor, viewFrom(editor.pose, side));
}

template <int step>
void stepRays(Editor& editor, UiState&) {
  editor.rayStep = step;
}

bool areRaysShown(const Editor& editor, const UiState&) {
  return editor.rays.show;
}

template <int direction>
void moveFocus(Editor&, UiState& ui) {
  moveKeyFocus(ui.keyFocus, reachableWindows(ui), direction);
}

bool canMoveFocus(const Editor&, const UiState& ui) {
  return !reachableWindows(ui).empty();
}

bool hasLesson(const Editor& editor, const UiState&) {
  return !editor.lesson.empty();
}

void undo(Editor& editor, UiState& ui) {
  letGo(editor, ui);
  editor.session.undo();
}

void resetLevel(Editor& editor, UiState& ui) {
  letGo(editor, ui);
  editor.session.reset();
}

// From the innermost out: a drag, an open menu, a lock on one pixel or vertex, the selection, an open window.
void cancel(Editor& editor, UiState& ui) {
  if (ui.mouse.drag != ViewDrag::none) return endViewDrag(editor, ui.mouse, false);
  if (editor.session.changing()) {
    letGoOfWidgets();
    return editor.session.cancelChange();
  }
  if (closePopups()) return;
  if (!ui.keyFocus.window.empty()) return leaveKeyFocus(ui.keyFocus);
  if (ui.tour.goesOn()) return endTour(ui.tour, ui.preferences);
  if (closeWindows(ui)) return;
  if (editor.preview.expanded) {
    editor.preview.expanded = false;
  } else if (editor.cell || editor.point) {
    pickPoint(editor, {});
  } else {
    editor.selection = {};
  }
}

void frame(Editor& editor, const Selection& selection) {
  const double aspect = double(std::max(1, editor.viewWidth)) / std::max(1, editor.viewHeight);
  flyTo(editor, frameBox(upright(editor.pose), boxOf(editor, selection), aspect));
}

void toggleParallel(Editor& editor, UiState&) {
  takeOverView(editor);
  editor.pose = togglePerspective(editor.pose);
}

void toggleFrozen(Editor& editor, UiState& ui) {
  letGo(editor, ui);
  anamorph::toggleFrozen(editor);
}

template <ShownAlone thing>
void toggleAlone(Editor& editor, UiState&) {
  ShownAlone& alone = editor.display.alone;
  alone = alone == thing ? ShownAlone::nothing : thing;
}

template <ShownAlone thing>
bool isAlone(const Editor& editor, const UiState&) {
  return editor.display.alone == thing;
}

// Panels make room for the view and the large words.
void togglePresenting(Editor&, UiState& ui) {
  ui.presenting = !ui.presenting;
  ui.panelsHidden = ui.presenting;
}

void openRenderWindow(Editor&, UiState& ui) {
  ui.render.open = true;
  if (ui.textures.render.id == 0 && !ui.render.running) ui.requests.startRender = true;
}

using namespace keys;

// Laid out by hand: the formatter would give every word of a row a line of its own.
// clang-format off
constexpr std::array<ActionRow, actionCount> table{{
    {Action::newLevel, "New level", "A box behind a plane mirror, to begin with", {{'N', control}},
     [](Editor&, UiState& ui) { ui.requests.startNew = true; }},
    {Action::open, "Open...", "A level, or a scene of the thesis", {{'O', control}}, chooseLevel},
    {Action::save, "Save", "An installed level is saved as one of your own", {{'S', control}}, saveCurrent},
    {Action::saveAs, "Save as...", "Under another name", {{'S', control | shift}}, saveCurrentAs},
    {Action::undo, "Undo", "One step back; a drag is one step", {{'Z', control}}, undo,
     [](const Editor& editor, const UiState&) { return editor.session.canUndo(); }},
    {Action::redo, "Redo", "One step forward again", {{'Y', control}, {'Z', control | shift}},
     [](Editor& editor, UiState&) { editor.session.redo(); },
     [](const Editor& editor, const UiState&) { return editor.session.canRedo(); }},
    {Action::cancel, "Cancel", "Ends a drag without its effect, then lets go of pixel, vertex and selection",
     {{escape}}, cancel},
    {Action::resetLevel, "Reset the level", "As it was opened or saved last; can be undone",
     {{'R', control}}, resetLevel,
     [](const Editor& editor, const UiState&) { return editor.session.modified(); }},
    {Action::copyLevel, "Copy the level", "As text, to be sent or pasted anywhere",
     {{'C', control | shift}}, [](Editor& editor, UiState&) { copyLevel(editor); }},
    {Action::copyLevelWithMesh, "Copy the level with its mesh", "As text, with the mesh of a file inside",
     {{'C', control | alt}}, copyLevelWithMesh,
     [](const Editor& editor, const UiState&) { return canCopyWithMesh(editor); }},
    {Action::pasteLevel, "Paste a level", "From a text, in place of this one; can be undone",
     {{'V', control | shift}}, pasteLevel},
    {Action::moveMode, "Move", "The gizmo moves the selection", {{'W'}, {}, {'T'}},
     setMode<GizmoMode::move>, always, hasMode<GizmoMode::move>},
    {Action::rotateMode, "Rotate", "The gizmo turns the selection", {{'E'}, {}, {'R'}},
     setMode<GizmoMode::rotate>, always, hasMode<GizmoMode::rotate>},
    {Action::scaleMode, "Scale", "The gizmo scales the selection", {{'R'}, {}, {'S'}},
     setMode<GizmoMode::scale>, always, hasMode<GizmoMode::scale>},
    {Action::toggleLocal, "Own axes", "The gizmo has the axes of the scene, or the selection's own", {{tab}},
     [](Editor& editor, UiState&) { editor.gizmoLocal = !editor.gizmoLocal; }, always,
     [](const Editor& editor, const UiState&) { return editor.gizmoLocal; }},
    {Action::toggleFrozen, "Freeze the sculpture",
     "It stays as it is, while eye, original and mirror move; again: it follows", {{'P'}}, toggleFrozen,
     [](const Editor& editor, const UiState&) { return canToggleFrozen(editor); },
     [](const Editor& editor, const UiState&) { return editor.session.level().sculpture.frozen.has_value(); }},
    {Action::lookThrough, "Look through the RT camera", "And back to where you were", {{'0'}, {pad0}},
     [](Editor& editor, UiState&) { toggleLookThrough(editor); }, always,
     [](const Editor& editor, const UiState&) { return editor.lookingThrough; }},
    {Action::frameSelection, "Frame the selection", "The view comes near enough to see it whole", {{'F'}},
     [](Editor& editor, UiState&) { frame(editor, editor.selection); }},
    {Action::frameAll, "Frame everything", "The view goes back far enough to see all", {{home}},
     [](Editor& editor, UiState&) { frame(editor, {}); }},
    {Action::viewFront, "From the front", "Along the y axis", {{'1'}, {pad0 + 1}},
     flyToSide<ViewSide::front>},
    {Action::viewRight, "From the right", "Along the x axis", {{'3'}, {pad0 + 3}},
     flyToSide<ViewSide::right>},
    {Action::viewTop, "From above", "Along the z axis", {{'7'}, {pad0 + 7}}, flyToSide<ViewSide::top>},
    {Action::toggleParallel, "Parallel projection", "And back to perspective", {{'5'}, {pad0 + 5}},
     toggleParallel, always, [](const Editor& editor, const UiState&) { return editor.pose.orthographic; }},
    {Action::hideMirror, "Hide the mirror", "In the 3D view, and show it again", {{'H'}},
     [](Editor& editor, UiState&) { editor.display.mirror = !editor.display.mirror; }, always,
     [](const Editor& editor, const UiState&) { return !editor.display.mirror; }},
    {Action::originalAlone, "Show only the original", "In the 3D view; again: everything", {{'1', alt}},
     toggleAlone<ShownAlone::original>, always, isAlone<ShownAlone::original>},
    {Action::sculptureAlone, "Show only the sculpture", "In the 3D view; again: everything", {{'2', alt}},
     toggleAlone<ShownAlone::sculpture>, always, isAlone<ShownAlone::sculpture>},
    {Action::mirrorAlone, "Show only the mirror", "In the 3D view; again: everything", {{'3', alt}},
     toggleAlone<ShownAlone::mirror>, always, isAlone<ShownAlone::mirror>},
    {Action::pauseRays, "Pause the rays", "While they are animated", {{space}},
     [](Editor& editor, UiState&) { editor.animationPaused = !editor.animationPaused; },
     [](const Editor& editor, const UiState&) { return editor.rays.animate; },
     [](const Editor& editor, const UiState&) { return editor.animationPaused; }},
    {Action::rayStepForward, "Rays: one piece further",
     "To where the next piece of a ray ends, and stay there", {{'.'}}, stepRays<1>, areRaysShown},
    {Action::rayStepBack, "Rays: one piece back", "", {{','}}, stepRays<-1>, areRaysShown},
    {Action::previousLevel, "Previous level", "", {{pageUp}}, openNeighbour<-1>, hasNeighbour<-1>},
    {Action::nextLevel, "Next level", "", {{pageDown}}, openNeighbour<1>, hasNeighbour<1>},
    {Action::previousStep, "Previous step", "Of the lesson; while presenting the left arrow, too",
     {{left, alt}}, [](Editor& editor, UiState&) { previousStep(editor); },
     [](const Editor& editor, const UiState&) { return !editor.lesson.empty() && editor.lesson.step > 0; }},
    {Action::nextStep, "Next step", "Of the lesson; while presenting the right arrow, too", {{right, alt}},
     [](Editor& editor, UiState&) { nextStep(editor); }, hasLesson},
    {Action::restartStep, "Begin the step again", "With the level that it is meant to begin with; can be undone",
     {{up, alt}}, [](Editor& editor, UiState&) { openStep(editor, editor.lesson.step); }, hasLesson},
    {Action::pointAtStep, "Where?", "Opens the tab and outlines what the lesson's step is about; you do it yourself",
     {{'M', shift}}, pointAtStep, [](const Editor& editor, const UiState&) { return canPointAt(editor.lesson); }},
    {Action::playStep, "Do it", "Makes the move of the lesson's step before your eyes", {{'M'}},
     doStep, [](const Editor& editor, const UiState&) { return canPlay(editor.lesson); }},
    {Action::progress, "Points and badges", "How far all lessons are done", {{f4}},
     [](Editor&, UiState& ui) { ui.progress.open = !ui.progress.open; }, always,
     [](const Editor&, const UiState& ui) { return ui.progress.open; }},
    {Action::present, "Present", "The step in large letters and a mark around the mouse, for an audience",
     {{f3}}, togglePresenting, always, [](const Editor&, const UiState& ui) { return ui.presenting; }},
    {Action::reload, "Reload the level", "From its file", {{f5}},
     [](Editor& editor, UiState& ui) { ui.requests.open = editor.session.path(); },
     [](const Editor& editor, const UiState&) { return !editor.session.path().empty(); }},
    {Action::renderImage, "Render an image", "In high resolution", {{'R', control | shift}},
     openRenderWindow},
    {Action::exportFiles, "Export...", "Sculpture, viewing sheet, rays, reports and pictures, to take home",
     {{'E', control}}, [](Editor&, UiState& ui) { ui.exporting.open = !ui.exporting.open; }},
    {Action::screenshot, "Screenshot", "Of the window, as PNG", {{f12}},
     [](Editor&, UiState& ui) { ui.requests.shot = ShotRequest{1, !ui.panelsHidden, false, {}}; }},
    {Action::help, "Help", "Keys, mouse and words", {{f1}},
     [](Editor&, UiState& ui) { ui.helpOpen = !ui.helpOpen; }},
    {Action::tour, "Show me around", "What is where in the window", {{f1, shift}},
     [](Editor&, UiState& ui) { startTour(ui.tour); }},
    {Action::hidePanels, "Hide the panels", "And show them again", {{f2}},
     [](Editor&, UiState& ui) { ui.panelsHidden = !ui.panelsHidden; }, always,
     [](const Editor&, const UiState& ui) { return ui.panelsHidden; }},
    {Action::nextPanel, "Keys into the next panel",
     "There arrows, Space and Enter work its controls; Esc goes back", {{f6}}, moveFocus<1>, canMoveFocus},
    {Action::previousPanel, "Keys into the panel before", "", {{f6, shift}}, moveFocus<-1>, canMoveFocus},
    {Action::fullscreen, "Full screen", "And back", {{f11}},
     [](Editor&, UiState& ui) { ui.requests.toggleFullscreen = true; }},
    {Action::quit, "Quit", "", {{'Q', control}}, [](Editor&, UiState& ui) { ui.requests.quit = true; }},
}};
// clang-format on

constexpr bool hasEveryActionOnce() {
  std::array<int, actionCount> times{};
  for (const ActionRow& row : table) ++times[static_cast<std::size_t>(row.action)];
  return std::all_of(times.begin(), times.end(), [](int count) { return count == 1; });
}
static_assert(hasEveryActionOnce());

}  // namespace

std::span<const ActionRow> actionTable() {
  return table;
}

const ActionRow& rowOf(Action action) {
  return *std::find_if(table.begin(), table.end(),
                       [&](const ActionRow& row) { return row.action == action; });
}

std::vector<Key> keysOf(const ActionRow& row, bool vrtKeys) {
  const bool asVrt = vrtKeys && row.keys.vrt.code != 0;
  std::vector<Key> all{asVrt ? row.keys.vrt : row.keys.first};
  if (row.keys.second.code != 0) all.push_back(row.keys.second);
  return all;
}

const ActionRow* findAction(const Key& key, bool vrtKeys) {
  for (const ActionRow& row : table) {
    for (const Key& own : keysOf(row, vrtKeys)) {
      if (own == key) return &row;
    }
  }
  return nullptr;
}

bool isEnabled(Action action, const Editor& editor, const UiState& ui) {
  return rowOf(action).enabled(editor, ui);
}

void perform(Action action, Editor& editor, UiState& ui) {
  const ActionRow& row = rowOf(action);
  if (row.enabled(editor, ui)) row.run(editor, ui);
}

bool isOpen(const Editor& editor, const LevelEntry& entry) {
  std::error_code ignored;
  if (entry.path.filename() != editor.session.path().filename()) return false;  // asks no disk
  return std::filesystem::equivalent(entry.path, editor.session.path(), ignored);
}

}  // namespace anamorph
