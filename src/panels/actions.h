// What can be done by a key, from a menu or by a button: one table, which menus, help, keyboard and buttons share.
// What cannot be done now is grey in the menu, and its key does nothing.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "panels/keys.h"
#include "panels/ui_state.h"

namespace anamorph {

enum class Action {
  newLevel,
  open,
  save,
  saveAs,
  copyLevel,
  copyLevelWithMesh,
  pasteLevel,
  reload,
  screenshot,
  renderImage,
  exportFiles,
  quit,
  undo,
  redo,
  resetLevel,
  cancel,
  moveMode,
  rotateMode,
  scaleMode,
  toggleLocal,
  toggleFrozen,
  frameSelection,
  frameAll,
  viewFront,
  viewRight,
  viewTop,
  toggleParallel,
  hideMirror,
  originalAlone,
  sculptureAlone,
  mirrorAlone,
  lookThrough,
  previousLevel,
  nextLevel,
  previousStep,
  nextStep,
  restartStep,
  pointAtStep,
  playStep,
  progress,
  present,
  pauseRays,
  rayStepForward,
  rayStepBack,
  help,
  tour,
  hidePanels,
  nextPanel,
  previousPanel,
  fullscreen,
};
constexpr std::size_t actionCount = static_cast<std::size_t>(Action::fullscreen) + 1;

/// Up to two; `vrt` takes the first one's place with the keys of Virtual Ray Tracer.
struct ActionKeys {
  Key first;
  Key second = {};
  Key vrt = {};
};

using ActionTest = bool (*)(const Editor&, const UiState&);
inline constexpr ActionTest always = [](const Editor&, const UiState&) { return true; };
inline constexpr ActionTest never = [](const Editor&, const UiState&) { return false; };

struct ActionRow {
  Action action;
  const char* name;  ///< English, as all texts
  const char* help;
  ActionKeys keys;
  void (*run)(Editor&, UiState&);
  ActionTest enabled = always;
  ActionTest ticked = never;  ///< in the menu
};

/// Every action once, in the order of the help.
std::span<const ActionRow> actionTable();
const ActionRow& rowOf(Action action);

/// The keys of an action, the first one for menus.
std::vector<Key> keysOf(const ActionRow& row, bool vrtKeys);
/// The row that has this key; null: none.
const ActionRow* findAction(const Key& key, bool vrtKeys);

bool isEnabled(Action action, const Editor& editor, const UiState& ui);
/// Does it, if it can be done now; what only the window can do is put into ui.requests.
void perform(Action action, Editor& editor, UiState& ui);

/// Whether the level that is open is this one, however its path is written.
bool isOpen(const Editor& editor, const LevelEntry& entry);

}  // namespace anamorph
