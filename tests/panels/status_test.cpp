// No sentence of the status line is about a level that is another one by now, whatever is done one after the other.

#include <filesystem>
#include <string>

#include "cli/program.h"
#include "panels/file_flow.h"
#include "panels/help_buttons.h"
#include "panels/level_sharing.h"
#include "panels/panels_fixture.h"
#include "panels/state_words.h"
#include "random_scene.h"

namespace anamorph::testing {
namespace {

class StatusOfTheLevel : public PanelsTest {
 protected:
  // One of the things that somebody does. Returns whether it may say something.
  bool act(Random& random) {
    switch (random.integer(0, 9)) {
      case 0:
        perform(Action::undo, editor, ui);
        return false;
      case 1:
        perform(Action::redo, editor, ui);
        return false;
      case 2:
        perform(Action::resetLevel, editor, ui);
        return false;
      case 3: {
        Level level = editor.session.level();
        level.camera.eye.x = random.uniform(-3, 3);
        editor.session.edit(level);
        return false;
      }
      case 4: {
        Level level = editor.session.level();
        level.sculpture.depthScale = random.uniform(0.2, 2);
        editor.session.change(level);
        return false;
      }
      case 5:
        perform(Action::copyLevel, editor, ui);
        return true;
      case 6:
        perform(Action::pasteLevel, editor, ui);
        return true;
      case 7:
        drag(random);
        return true;
      case 8:
        editor.status.sayOf(editor.session.level(), "The original is behind the mirror already.");
        return true;
      default:
        ui.browser.chosen = std::pair(FilePurpose::saveLevel, std::filesystem::path(folder / "mine.json"));
        settleRequests(editor, ui);
        return true;
    }
  }

  // Of a handle of the gizmo, kept or taken back.
  void drag(Random& random) {
    editor.session.finishChange();
    editor.selection = {random.integer(0, 1) == 0 ? Part::original : Part::eye};
    editor.point.reset();
    frame();
    const auto grip = gripOf(GizmoHandle::x);
    if (!grip) return;
    moveMouse(grip->x, grip->y);
    frames(2);
    press(true);
    frame();
    moveMouse(grip->x + static_cast<float>(random.uniform(-30, 30)), grip->y);
    frame();
    if (random.integer(0, 2) == 0) handleKey(keys::escape, 0, editor, ui);
    letGo();
  }

  TemporaryFolder folder;
};

TEST_F(StatusOfTheLevel, IsNeverAboutAnEarlierOne) {
  int said = 0, gone = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    Random random(seed);
    open("1-plane");
    frame();
    std::string last = editor.status.text();
    Level about = editor.session.level();
    for (int step = 0; step < 40; ++step) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " + std::to_string(step));
      const bool speaks = act(random);
      frame();
      const std::string& text = editor.status.text();
      const Level& level = editor.session.level();
      if (speaks && !text.empty()) {
        about = level;
        ++said;
      } else if (!text.empty()) {
        ASSERT_EQ(text, last);
        ASSERT_TRUE(level == about) << text;
      } else {
        gone += !last.empty();
      }
      last = text;
    }
  }
  EXPECT_GT(said, 100);
  EXPECT_GT(gone, 50);
}

TEST_F(StatusOfTheLevel, OfALevelThatWasLeftGoesWithTheFirstEdit) {
  open("1-plane");
  Level level = editor.session.level();
  level.camera.eye.z += 1;
  editor.session.edit(level);
  open("2-cylinder");
  open("1-plane");
  frame();
  EXPECT_NE(editor.status.text(), "");
  perform(Action::resetLevel, editor, ui);
  frame();
  EXPECT_EQ(editor.status.text(), "");
}

TEST(StateWords, SayNoMoreThanIsTrue) {
  LevelResult result;
  EXPECT_STREQ(stateWords(result, true), "loading");
  result.sculpture.sculpture = std::make_shared<const Sculpture>();
  EXPECT_STREQ(stateWords(result, true), "following, not refined yet");
  EXPECT_STREQ(stateWords(result, false), "not finished");
  for (const bool refines : {true, false}) {
    result.level.sculpture.tolerancePixels = refines ? 0.25 : 0;
    result.refined = true;
    result.complete = false;
    EXPECT_STREQ(stateWords(result, true),
                 refines ? "refined, being measured" : "not refined, being measured");
    EXPECT_STREQ(stateWords(result, false), "not finished");
    result.complete = true;
    EXPECT_STREQ(stateWords(result, false), refines ? "refined and measured" : "not refined, measured");
  }
  result.problem = "the eye is on the surface of the mirror";
  EXPECT_STREQ(stateWords(result, false), "no sculpture");
}

}  // namespace
}  // namespace anamorph::testing
