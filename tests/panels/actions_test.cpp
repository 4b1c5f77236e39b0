#include "panels/actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "edit/advance.h"
#include "edit/orbit.h"
#include "level/level_library.h"
#include "random_scene.h"

namespace anamorph {
namespace {

const std::filesystem::path levels = ANAMORPH_LEVELS;

std::vector<Action> allActions() {
  std::vector<Action> actions;
  for (int i = 0; i <= static_cast<int>(Action::fullscreen); ++i) actions.push_back(static_cast<Action>(i));
  return actions;
}

bool anythingAsked(const UiRequests& requests) {
  return requests.quit || requests.toggleFullscreen || requests.shot || requests.startRender ||
         requests.cancelRender || requests.saveRender || requests.open || requests.startNew;
}

TEST(Actions, EveryOneHasItsTextOnce) {
  std::set<std::string> names;
  for (const Action action : allActions()) {
    const auto& texts = actionTexts();
    const auto has = [&](const ActionText& text) { return text.action == action; };
    ASSERT_EQ(std::count_if(texts.begin(), texts.end(), has), 1) << int(action);
    const ActionText& text = *std::find_if(texts.begin(), texts.end(), has);
    EXPECT_NE(std::string(text.name), "");
    EXPECT_TRUE(names.insert(text.name).second) << text.name;
  }
}

TEST(Actions, NoTwoShortcutsHaveTheSameKey) {
  for (const bool vrtKeys : {false, true}) {
    std::set<std::pair<int, int>> used;
    for (const Shortcut& shortcut : shortcuts(vrtKeys)) {
      EXPECT_TRUE(used.insert({shortcut.key, shortcut.modifiers}).second) << shortcut.keyName;
      EXPECT_NE(std::string(shortcut.keyName), "");
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
  for (const Shortcut& shortcut : shortcuts(false)) {
    if (shortcut.key < 'A' || shortcut.key > 'Z') continue;
    std::string name;
    if (shortcut.modifiers & keys::control) name += "Ctrl+";
    if (shortcut.modifiers & keys::shift) name += "Shift+";
    EXPECT_EQ(shortcut.keyName, name + static_cast<char>(shortcut.key));
  }
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
      if (action == Action::showStep) continue;  // the lesson's move does change the level
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
  ui.viewDrag = ViewDrag::gizmo;
  Level other = opened;
  other.sculpture.depthScale = 2;
  editor.session.change(other);
  perform(Action::undo, editor, ui);
  EXPECT_EQ(ui.viewDrag, ViewDrag::none);
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
  ui.viewDrag = ViewDrag::gizmo;
  EXPECT_TRUE(handleKey('X', 0, editor, ui));
  EXPECT_EQ(ui.axisLock, 0);
  EXPECT_TRUE(handleKey('Z', 0, editor, ui));
  EXPECT_EQ(ui.axisLock, 2);
  EXPECT_TRUE(handleKey('Z', 0, editor, ui));
  EXPECT_EQ(ui.axisLock, -1);
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
