#include "panels/actions.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "edit/lesson_run.h"
#include "edit/orbit.h"
#include "panels/dialog.h"
#include "panels/export_entries.h"
#include "panels/file_flow.h"
#include "panels/key_focus.h"
#include "panels/lesson_text.h"
#include "panels/view_panel.h"
#include "panels/widgets.h"

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

void openNeighbour(const Editor& editor, UiState& ui, int offset) {
  if (const LevelEntry* entry = neighbour(editor, ui, offset)) ui.requests.open = entry->path;
}

// The export window by keys alone: the kind, and on to the file.
bool exportKey(int key, ExportDialog& dialog) {
  if (dialog.running) return false;
  if (key == keys::enter || key == keys::padEnter) {
    dialog.saveAsked = true;
  } else if (key == keys::left || key == keys::right) {
    const int count = static_cast<int>(exportEntries().size());
    dialog.kind = (dialog.kind + (key == keys::right ? 1 : count - 1)) % count;
  } else {
    return false;
  }
  return true;
}

// Panels make room for the view and the large words.
void togglePresenting(UiState& ui) {
  ui.presenting = !ui.presenting;
  ui.panelsHidden = ui.presenting;
}

void setMode(Editor& editor, GizmoMode mode) {
  editor.gizmoMode = mode;
}

// From the innermost out: a drag, an open menu, a lock on one pixel or vertex, the selection, an open window.
void cancel(Editor& editor, UiState& ui) {
  if (ui.viewDrag != ViewDrag::none) return endViewDrag(editor, ui, false);
  if (editor.session.changing()) {
    letGoOfWidgets();
    return editor.session.cancelChange();
  }
  if (closePopups()) return;
  if (!ui.keyPanel.empty()) return leaveKeyFocus(ui);
  if (ui.tourCard >= 0) {
    ui.tourCard = -1;
    ui.preferences.tourSeen = true;
  } else if (ui.render.open || ui.helpOpen || ui.progressOpen || ui.exporting.open) {
    ui.render.open = ui.helpOpen = ui.progressOpen = ui.exporting.open = false;
  } else if (editor.preview.expanded) {
    editor.preview.expanded = false;
  } else if (editor.cell || editor.point) {
    editor.cell.reset();
    editor.point.reset();
  } else {
    editor.selection = {};
  }
}

void frame(Editor& editor, const Selection& selection) {
  const double aspect = double(std::max(1, editor.viewWidth)) / std::max(1, editor.viewHeight);
  flyTo(editor, frameBox(upright(editor.pose), boxOf(editor, selection), aspect));
}

}  // namespace

bool hasNextLevel(const Editor& editor, const UiState& ui) {
  return neighbour(editor, ui, 1) != nullptr;
}

bool isOpen(const Editor& editor, const LevelEntry& entry) {
  std::error_code ignored;
  if (entry.path.filename() != editor.session.path().filename()) return false;  // asks no disk
  return std::filesystem::equivalent(entry.path, editor.session.path(), ignored);
}

const std::vector<ActionText>& actionTexts() {
  static const std::vector<ActionText> texts{
      {Action::newLevel, "New level", "A box behind a plane mirror, to begin with"},
      {Action::open, "Open...", "A level, or a scene of the thesis"},
      {Action::save, "Save", "An installed level is saved as one of your own"},
      {Action::saveAs, "Save as...", "Under another name"},
      {Action::undo, "Undo", "One step back; a drag is one step"},
      {Action::redo, "Redo", "One step forward again"},
      {Action::cancel, "Cancel",
       "Ends a drag without its effect, then lets go of pixel, vertex and selection"},
      {Action::resetLevel, "Reset the level", "As it was opened or saved last; can be undone"},
      {Action::copyLevel, "Copy the level", "As text, to be sent or pasted anywhere"},
      {Action::pasteLevel, "Paste a level", "From a text, in place of this one; can be undone"},
      {Action::moveMode, "Move", "The gizmo moves the selection"},
      {Action::rotateMode, "Rotate", "The gizmo turns the selection"},
      {Action::scaleMode, "Scale", "The gizmo scales the selection"},
      {Action::toggleLocal, "Own axes", "The gizmo has the axes of the scene, or the selection's own"},
      {Action::lookThrough, "Look through the RT camera", "And back to where you were"},
      {Action::frameSelection, "Frame the selection", "The view comes near enough to see it whole"},
      {Action::frameAll, "Frame everything", "The view goes back far enough to see all"},
      {Action::viewFront, "From the front", "Along the y axis"},
      {Action::viewRight, "From the right", "Along the x axis"},
      {Action::viewTop, "From above", "Along the z axis"},
      {Action::toggleParallel, "Parallel rays", "Orthographic view and back"},
      {Action::pauseRays, "Pause the rays", "While they are animated"},
      {Action::rayStepForward, "Rays: one piece further",
       "To where the next piece of a ray ends, and stay there"},
      {Action::rayStepBack, "Rays: one piece back", ""},
      {Action::previousLevel, "Previous level", ""},
      {Action::nextLevel, "Next level", ""},
      {Action::previousStep, "Previous step", "Of the lesson; while presenting the left arrow, too"},
      {Action::nextStep, "Next step", "Of the lesson; while presenting the right arrow, too"},
      {Action::showStep, "Show me", "Points at the control, and makes the move of the lesson's step"},
      {Action::progress, "Points and badges", "How far all lessons are done"},
      {Action::present, "Present", "The step in large letters and a mark around the mouse, for an audience"},
      {Action::reload, "Reload the level", "From its file"},
      {Action::renderImage, "Render an image", "In high resolution"},
      {Action::exportFiles, "Export...",
       "Sculpture, viewing sheet, rays, reports and pictures, to take home"},
      {Action::screenshot, "Screenshot", "Of the window, as PNG"},
      {Action::help, "Help", "Keys, mouse and words"},
      {Action::tour, "Show me around", "What is where in the window, in twenty seconds"},
      {Action::hidePanels, "Hide the panels", "And show them again"},
      {Action::nextPanel, "Keys into the next panel",
       "There arrows, Space and Enter work its controls; Esc goes back"},
      {Action::previousPanel, "Keys into the panel before", ""},
      {Action::fullscreen, "Full screen", "And back"},
      {Action::quit, "Quit", ""},
  };
  return texts;
}

std::vector<Shortcut> shortcuts(bool vrtKeys) {
  using namespace keys;
  std::vector<Shortcut> table{
      {Action::newLevel, 'N', control, "Ctrl+N"},
      {Action::open, 'O', control, "Ctrl+O"},
      {Action::save, 'S', control, "Ctrl+S"},
      {Action::saveAs, 'S', control | shift, "Ctrl+Shift+S"},
      {Action::copyLevel, 'C', control | shift, "Ctrl+Shift+C"},
      {Action::pasteLevel, 'V', control | shift, "Ctrl+Shift+V"},
      {Action::undo, 'Z', control, "Ctrl+Z"},
      {Action::redo, 'Y', control, "Ctrl+Y"},
      {Action::redo, 'Z', control | shift, "Ctrl+Shift+Z"},
      {Action::cancel, escape, 0, "Esc"},
      {Action::resetLevel, 'R', control, "Ctrl+R"},
      {Action::moveMode, vrtKeys ? 'T' : 'W', 0, vrtKeys ? "T" : "W"},
      {Action::rotateMode, vrtKeys ? 'R' : 'E', 0, vrtKeys ? "R" : "E"},
      {Action::scaleMode, vrtKeys ? 'S' : 'R', 0, vrtKeys ? "S" : "R"},
      {Action::toggleLocal, tab, 0, "Tab"},
      {Action::frameSelection, 'F', 0, "F"},
      {Action::frameAll, home, 0, "Home"},
      {Action::pauseRays, space, 0, "Space"},
      {Action::previousLevel, pageUp, 0, "Page Up"},
      {Action::nextLevel, pageDown, 0, "Page Down"},
      {Action::rayStepForward, '.', 0, "."},
      {Action::rayStepBack, ',', 0, ","},
      {Action::previousStep, left, alt, "Alt+Left"},
      {Action::nextStep, right, alt, "Alt+Right"},
      {Action::showStep, 'M', 0, "M"},
      {Action::present, f3, 0, "F3"},
      {Action::progress, f4, 0, "F4"},
      {Action::tour, f1, shift, "Shift+F1"},
      {Action::reload, f5, 0, "F5"},
      {Action::renderImage, 'R', control | shift, "Ctrl+Shift+R"},
      {Action::exportFiles, 'E', control, "Ctrl+E"},
      {Action::screenshot, f12, 0, "F12"},
      {Action::help, f1, 0, "F1"},
      {Action::hidePanels, f2, 0, "F2"},
      {Action::nextPanel, f6, 0, "F6"},
      {Action::previousPanel, f6, shift, "Shift+F6"},
      {Action::fullscreen, f11, 0, "F11"},
      {Action::quit, 'Q', control, "Ctrl+Q"},
  };
  struct Digit {
    Action action;
    int digit;
    const char* name;
  };
  for (const Digit& d : {Digit{Action::lookThrough, 0, "0"}, Digit{Action::viewFront, 1, "1"},
                         Digit{Action::viewRight, 3, "3"}, Digit{Action::toggleParallel, 5, "5"},
                         Digit{Action::viewTop, 7, "7"}}) {
    table.push_back({d.action, '0' + d.digit, 0, d.name});
    table.push_back({d.action, pad0 + d.digit, 0, d.name});
  }
  return table;
}

std::string keyNameOf(Action action, bool vrtKeys) {
  for (const Shortcut& shortcut : shortcuts(vrtKeys)) {
    if (shortcut.action == action) return shortcut.keyName;
  }
  return {};
}

void perform(Action action, Editor& editor, UiState& ui) {
  switch (action) {
    case Action::newLevel:
      ui.requests.startNew = true;
      return;
    case Action::open:
      return chooseLevel(editor, ui);
    case Action::save:
      return saveCurrent(editor, ui);
    case Action::saveAs:
      return saveCurrentAs(editor, ui);
    case Action::copyLevel:
      return copyLevel(editor);
    case Action::pasteLevel:
      return pasteLevel(editor, ui);
    case Action::undo:
      endViewDrag(editor, ui, true);
      letGoOfWidgets();
      return editor.session.undo();
    case Action::redo:
      return editor.session.redo();
    case Action::cancel:
      return cancel(editor, ui);
    case Action::resetLevel:
      endViewDrag(editor, ui, true);
      letGoOfWidgets();
      return editor.session.reset();
    case Action::moveMode:
      return setMode(editor, GizmoMode::move);
    case Action::rotateMode:
      return setMode(editor, GizmoMode::rotate);
    case Action::scaleMode:
      return setMode(editor, GizmoMode::scale);
    case Action::toggleLocal:
      editor.gizmoLocal = !editor.gizmoLocal;
      return;
    case Action::lookThrough:
      return toggleLookThrough(editor);
    case Action::frameSelection:
      return frame(editor, editor.selection);
    case Action::frameAll:
      return frame(editor, {});
    case Action::viewFront:
      return flyTo(editor, viewFrom(editor.pose, ViewSide::front));
    case Action::viewRight:
      return flyTo(editor, viewFrom(editor.pose, ViewSide::right));
    case Action::viewTop:
      return flyTo(editor, viewFrom(editor.pose, ViewSide::top));
    case Action::toggleParallel:
      takeOverView(editor);
      editor.pose = togglePerspective(editor.pose);
      return;
    case Action::pauseRays:
      editor.animationPaused = !editor.animationPaused;
      return;
    case Action::previousLevel:
      return openNeighbour(editor, ui, -1);
    case Action::nextLevel:
      return openNeighbour(editor, ui, 1);
    case Action::previousStep:
      return previousStep(editor);
    case Action::nextStep:
      return nextStep(editor);
    case Action::showStep:
      return showStep(editor, ui);
    case Action::progress:
      ui.progressOpen = !ui.progressOpen;
      return;
    case Action::present:
      return togglePresenting(ui);
    case Action::rayStepForward:
      editor.rayStep = 1;
      return;
    case Action::rayStepBack:
      editor.rayStep = -1;
      return;
    case Action::tour:
      ui.tourCard = 0;
      ui.tourSeconds = 0;
      return;
    case Action::reload:
      if (!editor.session.path().empty()) ui.requests.open = editor.session.path();
      return;
    case Action::renderImage:
      ui.render.open = true;
      if (ui.textures.render.id == 0 && !ui.render.running) ui.requests.startRender = true;
      return;
    case Action::exportFiles:
      ui.exporting.open = !ui.exporting.open;
      return;
    case Action::screenshot:
      ui.requests.shot = ShotRequest{1, !ui.panelsHidden, false, {}};
      return;
    case Action::help:
      ui.helpOpen = !ui.helpOpen;
      return;
    case Action::hidePanels:
      ui.panelsHidden = !ui.panelsHidden;
      return;
    case Action::nextPanel:
      return moveKeyFocus(ui, 1);
    case Action::previousPanel:
      return moveKeyFocus(ui, -1);
    case Action::fullscreen:
      ui.requests.toggleFullscreen = true;
      return;
    case Action::quit:
      ui.requests.quit = true;
      return;
  }
}

bool handleKey(int key, int modifiers, Editor& editor, UiState& ui, bool repeated) {
  if (isDialogOpen(ui)) {
    if (modifiers == 0) ui.dialogKeys.push_back({key, repeated});
    return true;
  }
  if (isForPanel(ui, key, modifiers)) return true;
  if (ui.viewDrag == ViewDrag::gizmo && key >= 'X' && key <= 'Z' && (modifiers & keys::control) == 0) {
    const int axis = key - 'X';
    ui.axisLock = ui.axisLock == axis ? -1 : axis;
    return true;
  }
  if (ui.presenting && modifiers == 0 && (key == keys::left || key == keys::right)) {
    perform(key == keys::left ? Action::previousStep : Action::nextStep, editor, ui);
    return true;
  }
  if (ui.exporting.open && modifiers == 0 && exportKey(key, ui.exporting)) return true;
  for (const Shortcut& shortcut : shortcuts(ui.preferences.vrtKeys)) {
    if (shortcut.key == key && shortcut.modifiers == modifiers) {
      perform(shortcut.action, editor, ui);
      return true;
    }
  }
  return false;
}

}  // namespace anamorph
