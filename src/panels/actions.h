// What can be done by a key or from a menu: one table of names and keys, which menus, help and the keyboard
// share.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edit/editor.h"
#include "panels/ui_state.h"

namespace anamorph {

enum class Action {
  newLevel,
  open,
  save,
  saveAs,
  copyLevel,
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
  frameSelection,
  frameAll,
  viewFront,
  viewRight,
  viewTop,
  toggleParallel,
  lookThrough,
  previousLevel,
  nextLevel,
  previousStep,
  nextStep,
  showStep,
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

/// Key codes as GLFW numbers them: letters and digits are their capital ASCII characters.
namespace keys {
constexpr int escape = 256, enter = 257, tab = 258, backspace = 259, right = 262, left = 263, down = 264,
              up = 265, pageUp = 266, pageDown = 267, home = 268, end = 269, padEnter = 335, f1 = 290,
              f2 = 291, f3 = 292, f4 = 293, f5 = 294, f6 = 295, f11 = 300, f12 = 301, pad0 = 320, space = 32;
constexpr int shift = 1, control = 2, alt = 4;
}  // namespace keys

struct Shortcut {
  Action action;
  int key;
  int modifiers;  ///< exactly these
  const char* keyName;
};

struct ActionText {
  Action action;
  const char* name;
  const char* help;
};

/// All actions, in the order of the help.
const std::vector<ActionText>& actionTexts();
std::vector<Shortcut> shortcuts(bool vrtKeys);

/// The first key of an action, for menus: "Ctrl+Z"; empty when it has none.
std::string keyNameOf(Action action, bool vrtKeys);

/// Whether the level that is open is this one, however its path is written.
bool isOpen(const Editor& editor, const LevelEntry& entry);

/// Whether the list has a level after the open one.
bool hasNextLevel(const Editor& editor, const UiState& ui);

/// Does it; what only the window can do is put into ui.requests.
void perform(Action action, Editor& editor, UiState& ui);

/// A key went down while no text is typed. Returns whether it meant something. X, Y and Z lock the axis of a
/// drag. While a dialog is open it gets the key, also while text is typed; `repeated`: it is held down.
bool handleKey(int key, int modifiers, Editor& editor, UiState& ui, bool repeated = false);

}  // namespace anamorph
