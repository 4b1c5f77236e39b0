#include "panels/actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "edit/advance.h"
#include "edit/level_files.h"
#include "edit/orbit.h"
#include "level/level_library.h"
#include "panels/key_input.h"
#include "random_scene.h"

namespace anamorph {
namespace {

const std::filesystem::path levels = ANAMORPH_LEVELS;

std::vector<Action> allActions() {
  std::vector<Action> actions;
  for (std::size_t i = 0; i < actionCount; ++i) actions.push_back(static_cast<Action>(i));
  return actions;
}

std::string keyNameOf(Action action, bool vrtKeys) {
  return keyName(keysOf(rowOf(action), vrtKeys).front());
}

bool anythingAsked(const UiRequests& requests) {
  return requests.quit || requests.toggleFullscreen || requests.shot || requests.startRender ||
         requests.cancelRender || requests.saveRender || requests.open || requests.startNew;
}

TEST(Actions, EveryOneHasItsRowOnce) {
  std::set<std::string> names;
  for (const Action action : allActions()) {
    const auto rows = actionTable();
    const auto has = [&](const ActionRow& row) { return row.action == action; };
    ASSERT_EQ(std::count_if(rows.begin(), rows.end(), has), 1) << int(action);
    const ActionRow& row = rowOf(action);
    EXPECT_EQ(row.action, action);
    EXPECT_NE(std::string(row.name), "");
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_TRUE(row.help && row.run && row.enabled && row.ticked) << row.name;
  }
}

TEST(Actions, NoTwoShortcutsHaveTheSameKey) {
  for (const bool vrtKeys : {false, true}) {
    std::set<std::pair<int, int>> used;
    for (const ActionRow& row : actionTable()) {
      for (const Key& key : keysOf(row, vrtKeys)) {
        EXPECT_TRUE(used.insert({key.code, key.modifiers}).second) << keyName(key);
        EXPECT_NE(keyName(key), "");
        EXPECT_EQ(findAction(key, vrtKeys), &row) << keyName(key);
      }
    }
  }
}

TEST(Actions, EveryOneCanBeDoneByAKey) {
  for (const bool vrtKeys : {false, true}) {
    for (const Action action : allActions()) EXPECT_NE(keyNameOf(action, vrtKeys), "") << int(action);
  }
  EXPECT_EQ(keyNameOf(Action::undo, false), "Ctrl+Z");
  EXPECT_EQ(keyNameOf(Action::moveMode, false), "W");
  EXPECT_EQ(keyNameOf(Action::moveMode, true), "T");
}

TEST(Actions, LettersAndDigitsHaveTheNameOfTheirKey) {
  for (const ActionRow& row : actionTable()) {
    const Key key = keysOf(row, false).front();
    if (key.code < 'A' || key.code > 'Z') continue;
    std::string name;
    if (key.modifiers & keys::control) name += "Ctrl+";
    if (key.modifiers & keys::shift) name += "Shift+";
    if (key.modifiers & keys::alt) name += "Alt+";
    EXPECT_EQ(keyName(key), name + static_cast<char>(key.code));
  }
  EXPECT_EQ(keyName({keys::left, keys::alt}), "Alt+Left");
  EXPECT_EQ(keyName({keys::pageUp}), "Page Up");
  EXPECT_EQ(keyName({keys::f12}), "F12");
  EXPECT_EQ(keyName({keys::pad0 + 7}), "7") << "as its digit";
  EXPECT_EQ(keyName({}), "");
}

// All that an action could change, in words.
std::string stateOf(const Editor& editor, const UiState& ui) {
  const UiRequests& r = ui.requests;
  std::string state = levelAsText(editor.session.level(), {});
  const auto add = [&](const auto&... values) { ((state += " " + fmt::format("{}", values)), ...); };
  add(editor.session.canUndo(), editor.session.canRedo(), editor.session.generation(), editor.status.text());
  add(int(editor.selection.part), editor.selection.index, editor.cell.has_value(), editor.point.has_value());
  add(int(editor.gizmoMode), editor.gizmoLocal, editor.pose.eye.x, editor.pose.eye.y, editor.pose.eye.z);
  add(editor.pose.orthographic, editor.flight.has_value(), editor.lookingThrough, editor.preview.expanded);
  add(editor.animationPaused, editor.animationSeconds, editor.rayStep, editor.lesson.step);
  add(editor.lesson.play.has_value(), editor.progress.size(), int(ui.mouse.drag), ui.keyFocus.window);
  add(r.quit, r.toggleFullscreen, r.shot.has_value(), r.startExport, r.startRender, r.startNew);
  add(r.open.value_or("").string(), ui.browser.open, ui.notice.has_value(), int(ui.tabs.open));
  add(ui.exporting.open, ui.render.open, ui.progress.open, ui.helpOpen, ui.tour.card, ui.presenting);
  add(ui.panelsHidden, ui.highlight.control);
  return state;
}

// Presses the keys of all actions that cannot be done, and adds these to `seen`.
void pressWhatIsDisabled(Editor& editor, UiState& ui, std::set<Action>& seen) {
  const std::string before = stateOf(editor, ui);
  for (const bool vrtKeys : {false, true}) {
    ui.preferences.vrtKeys = vrtKeys;
    for (const ActionRow& row : actionTable()) {
      if (isEnabled(row.action, editor, ui)) continue;
      seen.insert(row.action);
      for (const Key& key : keysOf(row, vrtKeys)) {
        EXPECT_TRUE(handleKey(key.code, key.modifiers, editor, ui)) << row.name << ": the key is taken";
        EXPECT_EQ(stateOf(editor, ui), before) << row.name;
      }
      perform(row.action, editor, ui);
      EXPECT_EQ(stateOf(editor, ui), before) << row.name;
    }
  }
}

TEST(Actions, AKeyOfWhatCannotBeDoneDoesNothing) {
  std::set<Action> seen;
  {
    Editor editor({}, 1);
    UiState ui;
    pressWhatIsDisabled(editor, ui, seen);
    editor.rays.show = false;
    pressWhatIsDisabled(editor, ui, seen);
  }
  UiState ui;
  ui.levels = listLevels(levels);
  for (const LevelEntry& entry : {ui.levels.front(), ui.levels.back()}) {
    Editor editor({}, 1);
    openLevel(editor, entry.path);
    advance(editor, 0.1);
    pressWhatIsDisabled(editor, ui, seen);
  }
  const std::set<Action> notAlways{Action::undo,
                                   Action::redo,
                                   Action::resetLevel,
                                   Action::reload,
                                   Action::pauseRays,
                                   Action::previousStep,
                                   Action::nextStep,
                                   Action::restartStep,
                                   Action::pointAtStep,
                                   Action::playStep,
                                   Action::rayStepForward,
                                   Action::rayStepBack,
                                   Action::nextPanel,
                                   Action::nextLevel,
                                   Action::previousPanel,
                                   Action::previousLevel,
                                   Action::copyLevelWithMesh,
                                   Action::toggleFrozen};
  EXPECT_EQ(seen, notAlways);
}

TEST(Actions, CanBeDoneAgainAsSoonAsThereIsWhatTheyAreAbout) {
  Editor editor({}, 1);
  UiState ui;
  ui.levels = listLevels(levels);
  openLevel(editor, ui.levels.at(1).path);
  advance(editor, 0.1);
  for (const Action action : {Action::reload, Action::previousLevel, Action::nextLevel, Action::nextStep,
                              Action::restartStep, Action::pointAtStep, Action::playStep})
    EXPECT_TRUE(isEnabled(action, editor, ui)) << rowOf(action).name;
  EXPECT_FALSE(isEnabled(Action::previousStep, editor, ui)) << "it is the first";
  perform(Action::nextStep, editor, ui);
  EXPECT_TRUE(isEnabled(Action::previousStep, editor, ui));
  EXPECT_FALSE(isEnabled(Action::undo, editor, ui));
  Level other = editor.session.level();
  other.sculpture.depthScale = 2;
  editor.session.change(other);
  EXPECT_TRUE(isEnabled(Action::undo, editor, ui)) << "a drag can be undone while it goes on";
  EXPECT_TRUE(isEnabled(Action::resetLevel, editor, ui));
  perform(Action::undo, editor, ui);
  EXPECT_FALSE(isEnabled(Action::undo, editor, ui));
  EXPECT_FALSE(isEnabled(Action::pauseRays, editor, ui));
  editor.rays.animate = true;
  EXPECT_TRUE(isEnabled(Action::pauseRays, editor, ui));
  EXPECT_FALSE(isEnabled(Action::nextPanel, editor, ui)) << "none is there";
  ui.panelsHidden = true;
  ui.exporting.open = true;
  EXPECT_TRUE(isEnabled(Action::nextPanel, editor, ui)) << "an open window can have the keyboard, too";
}

TEST(Actions, ATickSaysWhatIsOn) {
  Editor editor({}, 1);
  UiState ui;
  openLevel(editor, levels / "1-plane.json");
  editor.rays.animate = true;
  const auto ticked = [&](Action action) { return rowOf(action).ticked(editor, ui); };
  for (const Action action :
       {Action::toggleLocal, Action::lookThrough, Action::toggleParallel, Action::pauseRays, Action::progress,
        Action::hidePanels, Action::present, Action::hideMirror, Action::originalAlone}) {
    SCOPED_TRACE(rowOf(action).name);
    EXPECT_FALSE(ticked(action));
    perform(action, editor, ui);
    EXPECT_TRUE(ticked(action));
    perform(action, editor, ui);
    EXPECT_FALSE(ticked(action));
  }
  for (const Action mode : {Action::moveMode, Action::rotateMode, Action::scaleMode}) {
    perform(mode, editor, ui);
    for (const Action other : {Action::moveMode, Action::rotateMode, Action::scaleMode})
      EXPECT_EQ(ticked(other), other == mode);
  }
  EXPECT_FALSE(ticked(Action::save));
}

TEST(Actions, NoneHarmsAFreshEditor) {
  for (const Action action : allActions()) {
    SCOPED_TRACE(int(action));
    Editor editor({}, 1);
    UiState ui;
    for (int i = 0; i < 3; ++i) {
      EXPECT_NO_THROW(perform(action, editor, ui));
      EXPECT_NO_THROW(advance(editor, 0.1));
    }
    EXPECT_EQ(editor.session.level(), Level());
    EXPECT_FALSE(editor.session.canUndo() || editor.session.canRedo());
    EXPECT_EQ(ui.requests.open, std::nullopt) << "there is nothing that could be opened";
  }
}

TEST(Actions, NoneHarmsALevelInAnyOrder) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    testing::Random random(seed);
    Editor editor({}, 1);
    openLevel(editor, levels / "1-plane.json");
    editor.updater.cancel();
    UiState ui;
    ui.levels = listLevels(levels);
    for (int i = 0; i < 60; ++i) {
      const auto actions = allActions();
      const Action action = actions[static_cast<std::size_t>(random.integer(0, int(actions.size()) - 1))];
      // The moves and the starts of a lesson's steps and freezing do change the level.
      if (std::set{Action::playStep, Action::previousStep, Action::restartStep, Action::toggleFrozen}
              .contains(action))
        continue;
      perform(action, editor, ui);
      if (i % 3 == 0) advance(editor, 0.05);
      EXPECT_TRUE(isFinite(editor.pose.eye) && isFinite(editor.pose.target) && isFinite(editor.pose.up));
      EXPECT_FALSE(editor.session.modified());
    }
  }
}

TEST(Actions, OnlyTheWindowsOwnAreAskedOfIt) {
  const std::set<Action> asked{Action::reload,    Action::screenshot,  Action::quit,    Action::fullscreen,
                               Action::nextLevel, Action::renderImage, Action::newLevel};
  for (const Action action : allActions()) {
    Editor editor({}, 1);
    openLevel(editor, levels / "0-perspective.json");  // the first
    UiState ui;
    ui.levels = listLevels(levels);
    perform(action, editor, ui);
    EXPECT_EQ(anythingAsked(ui.requests), asked.count(action) > 0) << int(action);
  }
}

TEST(Actions, AnExportThatRunsIsNotAskedFor) {
  Editor editor({}, 1);
  UiState ui;
  ui.exporting.open = ui.exporting.running = true;
  const int kind = ui.exporting.kind;
  for (const int key : {keys::enter, keys::left, keys::right}) handleKey(key, 0, editor, ui);
  EXPECT_FALSE(ui.exporting.saveAsked);
  EXPECT_EQ(ui.exporting.kind, kind);
}

TEST(Actions, NeighboursEndAtTheFirstAndTheLastLevel) {
  UiState ui;
  ui.levels = listLevels(levels);
  ASSERT_GE(ui.levels.size(), 3u);
  Editor editor({}, 1);
  for (std::size_t i = 0; i < ui.levels.size(); ++i) {
    openLevel(editor, ui.levels[i].path);
    ui.requests = {};
    perform(Action::previousLevel, editor, ui);
    EXPECT_EQ(ui.requests.open.has_value(), i > 0);
    if (ui.requests.open) {
      EXPECT_EQ(*ui.requests.open, ui.levels[i - 1].path);
    }
    ui.requests = {};
    perform(Action::nextLevel, editor, ui);
    EXPECT_EQ(ui.requests.open.has_value(), i + 1 < ui.levels.size());
    if (ui.requests.open) {
      EXPECT_EQ(*ui.requests.open, ui.levels[i + 1].path);
    }
  }
}

TEST(Actions, NeighboursAreFoundHoweverThePathIsWritten) {
  UiState ui;
  ui.levels = listLevels(levels);
  Editor editor({}, 1);
  openLevel(editor, levels / ".." / "levels" / "0-perspective.json");
  perform(Action::nextLevel, editor, ui);
  ASSERT_TRUE(ui.requests.open);
  EXPECT_EQ(*ui.requests.open, ui.levels[1].path);
  ui.requests = {};
  openLevel(editor, std::filesystem::path(ANAMORPH_TEST_DATA) / "scenes" / "thesis-sphere.json");
  perform(Action::nextLevel, editor, ui);
  EXPECT_FALSE(ui.requests.open) << "it is not in the list";
}

TEST(Actions, CancelGoesFromTheInnermostOut) {
  Editor editor({}, 1);
  UiState ui;
  openLevel(editor, levels / "1-plane.json");
  const Level opened = editor.session.level();
  Level other = opened;
  other.sculpture.depthScale = 2;
  editor.session.change(other);
  ui.helpOpen = true;
  editor.preview.expanded = true;
  editor.cell = GridCell{1, 1};
  editor.point = PickedPoint{};
  editor.selection = {Part::mirror};
  perform(Action::cancel, editor, ui);
  EXPECT_EQ(editor.session.level(), opened);
  EXPECT_TRUE(ui.helpOpen);
  perform(Action::cancel, editor, ui);
  EXPECT_FALSE(ui.helpOpen);
  EXPECT_TRUE(editor.preview.expanded);
  perform(Action::cancel, editor, ui);
  EXPECT_FALSE(editor.preview.expanded);
  EXPECT_TRUE(editor.cell && editor.point);
  perform(Action::cancel, editor, ui);
  EXPECT_FALSE(editor.cell || editor.point);
  EXPECT_EQ(editor.selection.part, Part::mirror);
  perform(Action::cancel, editor, ui);
  EXPECT_EQ(editor.selection.part, Part::none);
}

TEST(Actions, UndoInADragTakesItBackWhole) {
  Editor editor({}, 1);
  UiState ui;
  openLevel(editor, levels / "1-plane.json");
  const Level opened = editor.session.level();
  ui.mouse.drag = ViewDrag::gizmo;
  Level other = opened;
  other.sculpture.depthScale = 2;
  editor.session.change(other);
  perform(Action::undo, editor, ui);
  EXPECT_EQ(ui.mouse.drag, ViewDrag::none);
  EXPECT_EQ(editor.session.level(), opened);
  perform(Action::redo, editor, ui);
  EXPECT_EQ(editor.session.level(), other);
}

TEST(Keys, DoWhatTheirTableSays) {
  Editor editor({}, 1);
  UiState ui;
  openLevel(editor, levels / "1-plane.json");
  EXPECT_TRUE(handleKey('E', 0, editor, ui));
  EXPECT_EQ(editor.gizmoMode, GizmoMode::rotate);
  EXPECT_FALSE(handleKey('W', keys::control, editor, ui));
  EXPECT_TRUE(handleKey('E', keys::control, editor, ui));
  EXPECT_TRUE(ui.exporting.open);
  EXPECT_FALSE(handleKey(999, 0, editor, ui));
  ui.preferences.vrtKeys = true;
  EXPECT_TRUE(handleKey('T', 0, editor, ui));
  EXPECT_EQ(editor.gizmoMode, GizmoMode::move);
  EXPECT_TRUE(handleKey('Q', keys::control, editor, ui));
  EXPECT_TRUE(ui.requests.quit);
}

TEST(Keys, LockTheAxisOfADrag) {
  Editor editor({}, 1);
  UiState ui;
  EXPECT_FALSE(handleKey('X', 0, editor, ui)) << "no drag";
  ui.mouse.drag = ViewDrag::gizmo;
  EXPECT_TRUE(handleKey('X', 0, editor, ui));
  EXPECT_EQ(ui.mouse.axisLock, 0);
  EXPECT_TRUE(handleKey('Z', 0, editor, ui));
  EXPECT_EQ(ui.mouse.axisLock, 2);
  EXPECT_TRUE(handleKey('Z', 0, editor, ui));
  EXPECT_EQ(ui.mouse.axisLock, -1);
}

TEST(Keys, NumberPadIsAsGoodAsTheDigits) {
  for (const int digit : {0, 1, 3, 5, 7}) {
    Editor a({}, 1), b({}, 1);
    UiState ui;
    EXPECT_TRUE(handleKey('0' + digit, 0, a, ui));
    EXPECT_TRUE(handleKey(keys::pad0 + digit, 0, b, ui));
    EXPECT_EQ(a.pose, b.pose);
    EXPECT_EQ(a.lookingThrough, b.lookingThrough);
    ASSERT_EQ(a.flight.has_value(), b.flight.has_value());
    if (a.flight) {
      EXPECT_EQ(a.flight->goal, b.flight->goal);
    }
  }
}

}  // namespace
}  // namespace anamorph
