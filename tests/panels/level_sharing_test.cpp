// Levels that come from elsewhere, and their meshes that stayed behind.

#include "panels/level_sharing.h"

#include <chrono>
#include <string>
#include <thread>
#include <tuple>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "edit/level_files.h"
#include "level/level_json.h"
#include "optics/mesh_mirror.h"
#include "panels/dialogs.h"
#include "panels/file_flow.h"
#include "panels_fixture.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;

const fs::path cube = fs::path(ANAMORPH_TEST_DATA) / "meshes/cube.obj";

class LevelSharing : public PanelsTest {
 protected:
  LevelSharing() {
    Level level;  // that takes no time
    level.original.shape = BoxShape{.segments = 2};
    level.sculpture.tolerancePixels = 0;
    level.text.edit([](LevelText& text) { text.title = "Mine"; });
    saveLevel(folder_ / "mine.json", level);
    level.original.shape = FileShape{"gone.obj"};
    saveLevel(folder_ / "gone.json", level);
    fs::copy_file(cube, folder_ / "cube.obj");
    ui.browser.recentFolders = {folder_ / ""};
    openFile("mine.json");
  }

  void openFile(const std::string& name) {
    openLevel(editor, folder_ / name);
    askForMissingMesh(editor, ui);
    editor.updater.finish(editor.session, {});
  }
  void step(int count = 2) {
    for (int i = 0; i < count; ++i) {
      frame();
      settleRequests(editor, ui);
    }
  }
  void key(int code) {
    handleKey(code, 0, editor, ui);
    step();
  }
  void act(Action action) {
    perform(action, editor, ui);
    step();
  }
  void paste(const std::string& text) {
    ImGui::SetClipboardText(text.c_str());
    act(Action::pasteLevel);
  }
  void waitForJob() {
    for (int i = 0; i < 60000 && editor.job.busy(); ++i) {
      step(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  // A level with this mesh, as another person's text.
  std::string sentWith(const std::string& mesh) {
    Level level = editor.session.level();
    level.original.shape = FileShape{mesh};
    return levelAsText(level, {});
  }
  void choose(const std::string& file) {
    ASSERT_TRUE(ui.browser.open);
    for (const char c : file) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
      step(1);
    }
    step();
    key(keys::enter);
  }
  std::string meshPath() const { return std::get<FileShape>(editor.session.level().original.shape).path; }

  TemporaryFolder folder_;
};

TEST_F(LevelSharing, WhatIsCopiedIsPastedAsOneStep) {
  Level level = editor.session.level();
  level.sculpture.depthScale = 3;
  editor.session.edit(level);
  act(Action::copyLevel);
  editor.session.undo();
  act(Action::pasteLevel);
  EXPECT_EQ(editor.session.level(), level);
  EXPECT_EQ(editor.status.text(), "The level has been pasted; Ctrl+Z takes it back.");
  editor.session.undo();
  EXPECT_FALSE(editor.session.modified()) << "one step";
}

TEST_F(LevelSharing, TheMeshOfAMirrorIsReadBesideTheWindowInOneStep) {
  Level level = editor.session.level();
  level.optic.shape() = MeshMirror{{"cube.obj", nullptr, {}}, {.position = {0, 3, 0}}};
  paste(levelAsText(level, editor.session.path()));
  waitForJob();
  const auto* mirror = editor.session.level().optic.shape().as<MeshMirror>();
  ASSERT_TRUE(mirror);
  EXPECT_TRUE(mirror->file.mesh);
  EXPECT_EQ(editor.status.text(), "The level has been pasted; Ctrl+Z takes it back.");
  editor.session.undo();
  EXPECT_FALSE(editor.session.modified()) << "one step";
}

TEST_F(LevelSharing, WhatWasMendedIsSaid) {
  std::string text = sentWith("cube.obj");
  text.insert(text.find("Mine") + 2, "\n");
  paste("Look:\n" + text);
  EXPECT_EQ(editor.status.text(),
            "The level has been pasted; Ctrl+Z takes it back. Mended: words around it left out, broken lines "
            "joined.");
  EXPECT_EQ(meshPath(), "cube.obj");
  EXPECT_FALSE(isDialogOpen(ui)) << "its mesh is beside the level";
}

TEST_F(LevelSharing, ATextThatIsNoLevelIsTold) {
  const Level before = editor.session.level();
  paste("{\"format\": \"anamorph-level\", \"version\": 1, \"camera\": 3}");
  ASSERT_TRUE(ui.notice);
  EXPECT_EQ(ui.notice->text.find("the text on the clipboard: line 1, column 1: expected the key"), 0u)
      << ui.notice->text;
  EXPECT_EQ(editor.session.level(), before);
  EXPECT_FALSE(editor.session.canUndo());
}

TEST_F(LevelSharing, AMissingMeshIsAskedForAndCancelPastesNothing) {
  const Level before = editor.session.level();
  paste(sentWith("/home/somebody/knot.obj"));
  ASSERT_STREQ(openDialog(ui), "mesh");
  EXPECT_EQ(ui.meshQuestion->mesh, folder_ / "knot.obj");
  EXPECT_EQ(editor.session.level(), before) << "not yet";
  key(keys::escape);
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(editor.session.level(), before);
  EXPECT_FALSE(editor.session.canUndo());
}

TEST_F(LevelSharing, AMissingMeshIsBrowsedFor) {
  const Level before = editor.session.level();
  paste(sentWith("knot.obj"));
  key(keys::enter);
  key(keys::escape);
  EXPECT_STREQ(openDialog(ui), "mesh") << "the browser was closed without a file: it is asked again";
  key(keys::enter);
  choose("cube");
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(meshPath(), "cube.obj");
  EXPECT_EQ(editor.session.level().original.placement, before.original.placement)
      << "the same mesh: nothing is fitted";
  editor.updater.finish(editor.session, {});
  EXPECT_EQ(editor.updater.result().original.mesh->positions.size(), 8u);
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), before) << "one step";
}

TEST_F(LevelSharing, AStandInIsWhereTheCameraLooks) {
  const Level before = editor.session.level();
  paste(sentWith("knot.obj"));
  key('S');
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_TRUE(std::holds_alternative<PawnShape>(editor.session.level().original.shape));
  EXPECT_EQ(editor.status.text(), "A pawn stands in for knot.obj; Ctrl+Z takes it back.");
  editor.updater.finish(editor.session, {});
  const Box box = boundingBox(editor.updater.result().original.mesh->positions);
  EXPECT_LT(glm::length(box.centre() - before.camera.target), 1e-6);
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), before);
}

TEST_F(LevelSharing, AMeshThatIsDroppedAnswersTheQuestion) {
  paste(sentWith("knot.obj"));
  acceptFiles({folder_ / "cube.obj"}, editor, ui);
  step();
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(meshPath(), "cube.obj");
}

TEST_F(LevelSharing, AnOpenedLevelAsksToo) {
  openFile("gone.json");
  step();
  ASSERT_STREQ(openDialog(ui), "mesh");
  key(keys::escape);
  EXPECT_EQ(meshPath(), "gone.obj") << "it is open, without a sculpture";
  EXPECT_FALSE(editor.session.modified());
  ASSERT_TRUE(editor.updater.result().problem);
  EXPECT_NE(editor.updater.result().problem->find("gone.obj"), std::string::npos);
  askForMesh(editor, ui);
  key('S');
  editor.updater.finish(editor.session, {});
  EXPECT_FALSE(editor.updater.result().problem) << *editor.updater.result().problem;
  editor.session.undo();
  EXPECT_EQ(meshPath(), "gone.obj");
}

TEST_F(LevelSharing, AMeshIsImportedThoughTheOldOneIsMissing) {
  openFile("gone.json");
  key(keys::escape);
  acceptFiles({folder_ / "cube.obj"}, editor, ui);
  waitForJob();
  EXPECT_EQ(meshPath(), "cube.obj") << editor.status.text();
}

TEST_F(LevelSharing, WhatCannotBeReadIsNotShownAsWhatWasBefore) {
  ASSERT_TRUE(editor.updater.result().shape);
  Level level = editor.session.level();
  level.original.shape = FileShape{"gone.obj"};
  editor.session.edit(level);
  editor.updater.finish(editor.session, {});
  EXPECT_TRUE(editor.updater.result().problem);
  EXPECT_FALSE(editor.updater.result().shape) << "so that nothing is offered that needs it";
  EXPECT_FALSE(editor.updater.result().original.mesh);
  step();
  editor.session.undo();
  editor.updater.finish(editor.session, {});
  EXPECT_FALSE(editor.updater.result().problem);
  EXPECT_TRUE(editor.updater.result().original.mesh);
}

TEST_F(LevelSharing, AMeshThatIsFoundStandsAsTheLevelSays) {
  Level level = editor.session.level();
  level.original.shape = FileShape{.path = "gone.obj", .up = ModelUp::x};
  editor.session.edit(level);
  askForMesh(editor, ui);
  giveMesh(folder_ / "cube.obj", editor, ui);
  EXPECT_EQ(editor.session.level().original.shape,
            OriginalShape(FileShape{.path = "cube.obj", .up = ModelUp::x}));
}

TEST_F(LevelSharing, AMeshTravelsInside) {
  EXPECT_FALSE(isEnabled(Action::copyLevelWithMesh, editor, ui)) << "it has none";
  Level level = editor.session.level();
  level.original.shape = FileShape{"cube.obj"};
  editor.session.edit(level);
  editor.updater.finish(editor.session, {});
  act(Action::copyLevel);
  EXPECT_EQ(editor.status.text(), "The level is on the clipboard, as text; it needs cube.obj, too.");
  act(Action::copyLevelWithMesh);
  EXPECT_EQ(editor.status.text(), "The level is on the clipboard, as text.");
  fs::remove(folder_ / "cube.obj");
  openFile("mine.json");
  act(Action::pasteLevel);
  EXPECT_FALSE(isDialogOpen(ui));
  editor.updater.finish(editor.session, {});
  EXPECT_EQ(editor.updater.result().original.mesh->positions.size(), 8u);
  act(Action::copyLevel);
  EXPECT_EQ(editor.status.text(), "The level is on the clipboard, as text.") << "it stays inside";
}

TEST_F(LevelSharing, ALargeMeshIsToldToStay) {
  fs::copy_file(fs::path(ANAMORPH_TEST_DATA) / "meshes/box.obj", folder_ / "box.obj");
  Level level = editor.session.level();
  level.original.shape = FileShape{"box.obj"};
  editor.session.edit(level);
  editor.updater.finish(editor.session, {});
  ImGui::SetClipboardText("as before");
  act(Action::copyLevelWithMesh);
  ASSERT_TRUE(ui.notice);
  EXPECT_EQ(ui.notice->text.find("box.obj has "), 0u) << ui.notice->text;
  EXPECT_STREQ(ImGui::GetClipboardText(), "as before");
}

TEST_F(LevelSharing, TheQuestionFitsEveryWindow) {
  ui.meshQuestion = MeshQuestion{editor.session.level(), fs::path("/" + std::string(200, 'W')) / "knot.obj"};
  for (const auto& [width, height, scale] :
       {std::tuple{800.0f, 500.0f, 2.0}, {1280.0f, 800.0f, 1.0}, {320.0f, 200.0f, 3.0}, {1.0f, 1.0f, 1.0}}) {
    ImGui::GetIO().DisplaySize = {width, height};
    setLook(Theme::projector, scale);
    step();
  }
}

}  // namespace
}  // namespace anamorph::testing
