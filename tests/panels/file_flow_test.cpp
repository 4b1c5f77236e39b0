// The File menu, as the GUI runs it: wishes, questions, deeds.

#include "panels/file_flow.h"

#include <chrono>
#include <string>
#include <thread>
#include <tuple>

#include <gtest/gtest.h>

#include "base/error.h"
#include "cli/program.h"
#include "exports/export_formats.h"
#include "level/level_json.h"
#include "panels/dialogs.h"
#include "panels/file_browser.h"
#include "panels_fixture.h"
#include "save_session.h"

namespace anamorph::testing {
namespace {

namespace fs = std::filesystem;

class FileFlow : public PanelsTest {
 protected:
  FileFlow() {
    fs::copy_file(fs::path(ANAMORPH_LEVELS) / "1-plane.json", folder_ / "mine.json");
    fs::copy_file(fs::path(ANAMORPH_LEVELS) / "3-sphere.json", folder_ / "other.json");
    openLevel(editor, folder_ / "mine.json");
    editor.updater.finish(editor.session, {});
    ui.browser.recentFolders = {folder_ / ""};
  }

  // As Gui::frame.
  void step(int count = 1) {
    for (int i = 0; i < count; ++i) {
      do {
        frame();
        settleRequests(editor, ui);
      } while (editor.saving.busy());
      if (const auto path = std::exchange(ui.requests.open, std::nullopt)) {
        opened_ = *path;
        openLevel(editor, *path);
        rememberLevel(ui, *path);
      }
      if (std::exchange(ui.requests.startNew, false)) openNewLevel(editor);
    }
  }
  void key(int code) {
    handleKey(code, 0, editor, ui);
    step(2);
  }
  void act(Action action) {
    perform(action, editor, ui);
    step(2);
  }
  void modify(double depthScale = 2) {
    Level level = editor.session.level();
    level.sculpture.depthScale = depthScale;
    editor.session.edit(level);
    step();
  }
  double savedDepth(const std::string& name) const {
    return loadLevel(folder_ / name).level.sculpture.depthScale;
  }
  void type(const std::string& text) {
    for (const char c : text) {
      ImGui::GetIO().AddInputCharacter(static_cast<unsigned char>(c));
      step();
    }
    step();
  }
  void waitForJob() {
    for (int i = 0; i < 3000 && editor.job.busy(); ++i) {
      step();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    step(2);
  }

  TemporaryFolder folder_;
  fs::path opened_;
};

TEST_F(FileFlow, SavesToTheLevelsOwnFile) {
  modify();
  act(Action::save);
  EXPECT_FALSE(editor.session.modified());
  EXPECT_EQ(savedDepth("mine.json"), 2);
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_NE(editor.status.text().find("mine.json"), std::string::npos);
  EXPECT_EQ(ui.recentLevels.front(), folder_ / "mine.json");
}

TEST_F(FileFlow, AnInstalledLevelIsNeverWritten) {
  open("2-cylinder");
  const fs::path file = editor.session.path();
  const std::string before = readAll(file);
  modify();
  act(Action::save);
  EXPECT_TRUE(ui.browser.open);
  EXPECT_EQ(ui.browser.text, "2-cylinder-copy.json");
  EXPECT_EQ(ui.browser.folder, fs::path(folder_ / "").parent_path());
  key(keys::enter);
  EXPECT_EQ(editor.session.path(), folder_ / "2-cylinder-copy.json");
  EXPECT_FALSE(editor.session.modified());
  EXPECT_EQ(readAll(file), before);
  modify(3);
  act(Action::save);
  EXPECT_FALSE(isDialogOpen(ui)) << "now it has a file of its own";
  EXPECT_EQ(savedDepth("2-cylinder-copy.json"), 3);
}

TEST_F(FileFlow, AFileThatAnotherProgramWroteIsReplacedOnlyWhenAsked) {
  modify();
  const fs::path file = folder_ / "mine.json";
  fs::copy_file(folder_ / "other.json", file, fs::copy_options::overwrite_existing);
  fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds(5));
  const std::string theirs = loadLevel(file).level.text->title;
  act(Action::save);
  ASSERT_TRUE(ui.browser.open);
  EXPECT_NE(ui.browser.problem.find("another program"), std::string::npos);
  EXPECT_EQ(loadLevel(file).level.text->title, theirs);
  key(keys::escape);
  EXPECT_TRUE(editor.session.modified());
  EXPECT_EQ(loadLevel(file).level.text->title, theirs);
  act(Action::save);
  key(keys::enter);  // the name that is proposed
  key(keys::enter);  // replace it
  EXPECT_FALSE(ui.browser.open);
  EXPECT_EQ(savedDepth("mine.json"), 2);
  modify(3);
  act(Action::save);
  EXPECT_FALSE(ui.browser.open) << "now it is one's own again";
  EXPECT_EQ(savedDepth("mine.json"), 3);
}

TEST_F(FileFlow, ANewLevelGetsAName) {
  act(Action::newLevel);
  EXPECT_TRUE(editor.session.path().empty());
  EXPECT_FALSE(editor.session.modified());
  act(Action::save);
  EXPECT_TRUE(ui.browser.open);
  type("fresh");
  key(keys::enter);
  EXPECT_EQ(editor.session.path(), folder_ / "fresh.json");
  EXPECT_EQ(loadLevel(folder_ / "fresh.json").level, editor.session.level());
}

TEST_F(FileFlow, WithoutChangesNothingIsAsked) {
  ui.requests.open = folder_ / "other.json";
  step();
  EXPECT_EQ(opened_, folder_ / "other.json");
  act(Action::reload);
  EXPECT_FALSE(isDialogOpen(ui));
  act(Action::quit);
  EXPECT_TRUE(ui.requests.quit);
}

TEST_F(FileFlow, EveryWayOutAsks) {
  modify();
  const Level level = editor.session.level();
  const std::vector<std::function<void()>> ways{
      [&] { ui.requests.open = folder_ / "other.json"; }, [&] { perform(Action::newLevel, editor, ui); },
      [&] { perform(Action::reload, editor, ui); }, [&] { perform(Action::quit, editor, ui); },
      [&] { acceptFiles({folder_ / "other.json"}, editor, ui); }};
  for (const auto& way : ways) {
    way();
    step(2);
    EXPECT_TRUE(ui.unsaved);
    EXPECT_EQ(editor.session.level(), level);
    key(keys::escape);
    EXPECT_FALSE(isDialogOpen(ui));
    EXPECT_FALSE(ui.requests.quit);
    EXPECT_EQ(editor.session.level(), level) << "nothing has happened";
    EXPECT_EQ(opened_, "");
  }
}

TEST_F(FileFlow, SavingThenGoesOn) {
  modify();
  ui.requests.open = folder_ / "other.json";
  step(2);
  key(keys::enter);
  EXPECT_EQ(opened_, folder_ / "other.json");
  EXPECT_EQ(savedDepth("mine.json"), 2);
}

TEST_F(FileFlow, NotSavingGoesOnWithout) {
  modify();
  perform(Action::quit, editor, ui);
  step(2);
  handleKey('D', 0, editor, ui);
  step();
  EXPECT_TRUE(ui.requests.quit);
  EXPECT_EQ(savedDepth("mine.json"), 1);
  EXPECT_TRUE(editor.session.modified()) << "should quitting fail after all, it is still there";
}

TEST_F(FileFlow, SavingUnderANameThenGoesOn) {
  act(Action::newLevel);
  modify();
  ui.requests.open = folder_ / "other.json";
  step(2);
  key(keys::enter);
  ASSERT_TRUE(ui.browser.open);
  EXPECT_EQ(opened_, "");
  key(keys::enter);
  EXPECT_EQ(opened_, folder_ / "other.json");
  EXPECT_EQ(savedDepth("level.json"), 2);
}

TEST_F(FileFlow, QuittingWhileAFileIsWrittenAsks) {
  const std::function<void(bool)> writings[] = {
      [&](bool on) { ui.exporting.running = ui.exporting.writing = on; },
      [&](bool on) { ui.render.saving = on ? "picture.png" : ""; }, [&](bool on) { ui.shot.running = on; }};
  for (const auto& setWriting : writings) {
    setWriting(true);
    act(Action::quit);
    ASSERT_TRUE(ui.finish);
    EXPECT_FALSE(ui.requests.quit);
    key(keys::escape);
    EXPECT_FALSE(ui.finish || ui.requests.quit) << "it goes on, and so does the window";

    act(Action::quit);
    key(keys::enter);  // wait
    EXPECT_TRUE(ui.finish);
    EXPECT_FALSE(ui.requests.quit);
    setWriting(false);
    step();
    EXPECT_TRUE(std::exchange(ui.requests.quit, false)) << "it is written";

    setWriting(true);
    act(Action::quit);
    handleKey('S', 0, editor, ui);  // stop
    step();
    EXPECT_TRUE(std::exchange(ui.requests.quit, false));
    setWriting(false);
  }
}

TEST_F(FileFlow, QuittingThatWaitsForAFileThatFailsIsGivenUp) {
  ui.render.saving = "picture.png";
  act(Action::quit);
  key(keys::enter);
  giveUpQuitting(ui, "picture.png: cannot write: No space left on device");
  ui.render.saving.clear();
  step(2);
  EXPECT_FALSE(ui.finish || ui.requests.quit);
  ASSERT_TRUE(ui.notice);
  EXPECT_NE(ui.notice->text.find("No space"), std::string::npos);
}

TEST_F(FileFlow, QuittingAsksAboutChangesBeforeFiles) {
  modify();
  ui.exporting.running = ui.exporting.writing = true;
  act(Action::quit);
  EXPECT_TRUE(ui.unsaved && !ui.finish);
  key(keys::enter);
  EXPECT_EQ(savedDepth("mine.json"), 2);
  EXPECT_TRUE(!ui.unsaved && ui.finish);
}

// Two windows of a file: whoever saves second is asked.
TEST_F(FileFlow, ASecondWindowOfTheFileIsAskedBeforeItReplaces) {
  Session other;
  other.open(folder_ / "mine.json");
  modify();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // clocks of files are not finer
  act(Action::save);
  ASSERT_FALSE(isDialogOpen(ui));
  EXPECT_TRUE(isWrittenElsewhere(other.path(), other.fileTime()));
  Level theirs = other.level();
  theirs.sculpture.depthScale = 5;
  other.edit(theirs);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  testing::saveTo(other, folder_ / "mine.json");  // replaces it all the same
  modify(3);
  act(Action::save);
  ASSERT_TRUE(ui.browser.open);
  EXPECT_NE(ui.browser.problem.find("another program"), std::string::npos);
  EXPECT_EQ(savedDepth("mine.json"), 5);
}

TEST_F(FileFlow, NoNameIsNoStep) {
  act(Action::newLevel);
  modify();
  ui.requests.open = folder_ / "other.json";
  step(2);
  key(keys::enter);
  ASSERT_TRUE(ui.browser.open);
  key(keys::escape);
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(opened_, "");
  EXPECT_TRUE(editor.session.modified());
}

TEST_F(FileFlow, AnInstalledLevelIsLeftWithoutAQuestionAndFoundAsItWas) {
  open("1-plane");
  const fs::path plane = editor.session.path();
  const Level before = editor.session.level();
  modify();
  const Level changed = editor.session.level();
  ui.requests.open = folder_ / "other.json";
  step(2);
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(opened_, folder_ / "other.json");
  ui.requests.open = plane;
  step(2);
  EXPECT_EQ(editor.session.level(), changed);
  act(Action::resetLevel);
  EXPECT_EQ(editor.session.level(), before);
  modify();
  act(Action::reload);
  EXPECT_TRUE(ui.unsaved) << "reloading would lose it";
  key(keys::escape);
  EXPECT_FALSE(ui.unsaved);
}

TEST_F(FileFlow, ALevelIsLeftWhateverItsPathLooksLike) {
  const fs::path plane = fs::path(ANAMORPH_LEVELS) / "1-plane.json";
  openLevel(editor, fs::path(ANAMORPH_LEVELS) / ".." / fs::path(ANAMORPH_LEVELS).filename() / "1-plane.json");
  editor.updater.finish(editor.session, {});
  modify();
  const Level changed = editor.session.level();
  ui.requests.open = plane;
  step(2);
  EXPECT_TRUE(ui.unsaved) << "it is the open one";
  key(keys::escape);
  ui.requests.open = folder_ / "other.json";
  step(2);
  ui.requests.open = plane;
  step(2);
  EXPECT_EQ(editor.session.level(), changed);
}

TEST_F(FileFlow, WhatIsStillOpenWasNotLeft) {
  open("1-plane");
  modify();
  EXPECT_THROW(openLevel(editor, folder_ / "none.json"), Error);
  EXPECT_TRUE(editor.leftLevels.empty());
  openLevel(editor, fs::path(ANAMORPH_LEVELS) / "1-plane.json");
  EXPECT_FALSE(editor.session.modified()) << "read anew";
  EXPECT_TRUE(editor.leftLevels.empty());
}

TEST_F(FileFlow, QuittingTellsWhatWasLeft) {
  open("1-plane");
  modify();
  ui.requests.open = folder_ / "other.json";
  step(2);
  perform(Action::quit, editor, ui);
  step(2);
  ASSERT_TRUE(ui.unsaved);
  key(keys::escape);
  EXPECT_FALSE(ui.requests.quit);
  perform(Action::quit, editor, ui);
  step(2);
  handleKey(keys::enter, 0, editor, ui);
  step();
  EXPECT_TRUE(ui.requests.quit);
}

TEST_F(FileFlow, ProposesANameMadeOfTheTitle) {
  act(Action::newLevel);
  Level level = editor.session.level();
  level.text.edit([&](LevelText& text) { text.title = " Mijn 1e zuil: (blauw)! "; });
  editor.session.edit(level);
  act(Action::saveAs);
  EXPECT_EQ(ui.browser.text, "mijn-1e-zuil-blauw.json");
}

TEST_F(FileFlow, AFailedSaveSaysWhyAndStays) {
  modify();
  fs::remove(folder_ / "mine.json");
  fs::create_directory(folder_ / "mine.json");
  ui.requests.open = folder_ / "other.json";
  step(2);
  key(keys::enter);
  ASSERT_TRUE(ui.notice);
  EXPECT_NE(ui.notice->text.find("mine.json"), std::string::npos);
  key(keys::enter);
  EXPECT_FALSE(isDialogOpen(ui));
  EXPECT_EQ(opened_, "") << "it was not left";
  EXPECT_TRUE(editor.session.modified());
  EXPECT_EQ(editor.session.level().sculpture.depthScale, 2);
}

TEST_F(FileFlow, AMeshThatIsDroppedTakesTheOriginalsPlace) {
  const Box box = boundingBox(editor.updater.result().original.mesh->positions);
  const Level before = editor.session.level();
  fs::copy_file(fs::path(ANAMORPH_TEST_DATA) / "meshes/cube.obj", folder_ / "cube.obj");
  acceptFiles({folder_ / "cube.obj"}, editor, ui);
  waitForJob();
  EXPECT_EQ(std::get<FileShape>(editor.session.level().original.shape).path, "cube.obj")
      << "relative to the level";
  editor.updater.finish(editor.session, {});
  const Box now = boundingBox(editor.updater.result().original.mesh->positions);
  EXPECT_LT(glm::length(now.centre() - box.centre()), 1e-9);
  EXPECT_NEAR(now.size().z, 2, 1e-9);
  EXPECT_EQ(editor.updater.result().problem, std::nullopt);
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), before) << "one step";
}

TEST_F(FileFlow, AMeshWithoutUseIsTold) {
  const Level before = editor.session.level();
  writeText(folder_ / "broken.obj", "f 1 2 3\n");
  acceptFiles({folder_ / "broken.obj"}, editor, ui);
  waitForJob();
  EXPECT_NE(editor.status.text().find("broken.obj"), std::string::npos) << editor.status.text();
  EXPECT_EQ(editor.session.level(), before);
  EXPECT_FALSE(editor.session.canUndo());
}

TEST_F(FileFlow, OtherFilesAreToldWhatIsAccepted) {
  acceptFiles({folder_ / "picture.jpeg"}, editor, ui);
  ASSERT_TRUE(ui.notice);
  EXPECT_NE(ui.notice->text.find("picture.jpeg"), std::string::npos);
  EXPECT_NE(ui.notice->text.find(".stl"), std::string::npos);
  step(2);
  key(keys::escape);
  EXPECT_FALSE(isDialogOpen(ui));
  acceptFiles({}, editor, ui);
  EXPECT_FALSE(ui.notice);
  acceptFiles({folder_ / "picture.jpeg", folder_ / "other.json"}, editor, ui);
  step();
  EXPECT_EQ(opened_, folder_ / "other.json") << "the first that can be used";
}

TEST_F(FileFlow, OtherModelsAreToldTheWayOut) {
  acceptFiles({folder_ / "part.step"}, editor, ui);
  ASSERT_TRUE(ui.notice);
  EXPECT_NE(ui.notice->text.find("STEP is not read; export it as STL or OBJ."), std::string::npos)
      << ui.notice->text;
}

TEST_F(FileFlow, WhatAMeshFileHasLostIsTold) {
  writeText(folder_ / "wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 3 4\nf 1 2\n");
  acceptFiles({folder_ / "wedge.obj"}, editor, ui);
  waitForJob();
  EXPECT_NE(editor.status.text().find("2 triangles"), std::string::npos) << editor.status.text();
  EXPECT_NE(editor.status.text().find("wedge.obj: line 7: 1 face of fewer than three corners left out"),
            std::string::npos)
      << editor.status.text();
  editor.updater.finish(editor.session, {});
  EXPECT_EQ(editor.updater.result().shapeWarnings.size(), 1u);
}

TEST_F(FileFlow, AMeshThatLiesIsStoodUpAndUndoingLaysItDown) {
  const Level before = editor.session.level();
  acceptFiles({fs::path(ANAMORPH_TEST_DATA) / "field/obj-y-up/house.obj"}, editor, ui);
  waitForJob();
  const auto up = [&] { return std::get<FileShape>(editor.session.level().original.shape).up; };
  EXPECT_EQ(up(), ModelUp::y);
  EXPECT_NE(editor.status.text().find("Its y axis is taken to point up"), std::string::npos)
      << editor.status.text();
  editor.session.undo();
  EXPECT_EQ(up(), ModelUp::z);
  editor.session.undo();
  EXPECT_EQ(editor.session.level(), before);
}

TEST_F(FileFlow, ASceneOfTheThesisKeepsTheMeshsSize) {
  openLevel(editor, fs::path(ANAMORPH_TEST_DATA) / "scenes/thesis-sphere.json");
  editor.updater.finish(editor.session, {});
  const Level before = editor.session.level();
  importOriginal(editor, fs::path(ANAMORPH_TEST_DATA) / "meshes/cube.obj");
  waitForJob();
  EXPECT_EQ(editor.session.level().original.placement, before.original.placement);
}

TEST_F(FileFlow, RecentLevelsAreThoseOfOnesOwnNewestFirst) {
  for (const char* name : {"mine.json", "other.json", "mine.json"}) {
    ui.requests.open = folder_ / name;
    step();
  }
  ui.requests.open = fs::path(ANAMORPH_LEVELS) / "2-cylinder.json";
  step();
  EXPECT_EQ(ui.recentLevels, (std::vector<fs::path>{folder_ / "mine.json", folder_ / "other.json"}));
  for (int i = 0; i < 30; ++i) rememberLevel(ui, folder_ / (std::to_string(i) + ".json"));
  EXPECT_EQ(ui.recentLevels.size(), 10u);
  EXPECT_EQ(ui.browser.recentFolders.size(), 1u + (ui.browser.recentFolders.back() == folder_ / ""));
}

TEST_F(FileFlow, DialogsFitEveryWindow) {
  ui.recovery.entries = {
      {folder_ / "mine.json", "The plane mirror", "today, 12:03", ""},
      {{}, std::string(200, 'W'), "yesterday", "cannot be read: " + std::string(300, 'x')}};
  for (const auto& [width, height, scale] :
       {std::tuple{800.0f, 500.0f, 2.0}, {1280.0f, 800.0f, 1.0}, {320.0f, 200.0f, 3.0}, {1.0f, 1.0f, 1.0}}) {
    for (const Theme theme : {Theme::dark, Theme::projector}) {
      ImGui::GetIO().DisplaySize = {width, height};
      setLook(theme, scale * themeScale(theme));
      step(2);
      ui.unsaved = UnsavedQuestion{};
      step(2);
      ui.notice = Notice{"The level could not be saved", std::string(500, 'y')};
      step(2);
      ui.notice.reset();
      ui.unsaved.reset();
    }
  }
}

TEST_F(FileFlow, OfTwoStatesOfALevelTheNewerIsKeptByEnter) {
  using Kind = RecoveryAnswer::Kind;
  for (const auto& [fileIsNewer, expected] : {std::pair{false, Kind::restore}, {true, Kind::discard}}) {
    ui.recovery.entries = {{folder_ / "mine.json", "One", "", "", fileIsNewer}};
    step(2);
    key(keys::enter);
    ASSERT_TRUE(ui.requests.recovery);
    EXPECT_EQ(ui.requests.recovery->kind, expected);
    ui.requests.recovery.reset();
  }
}

TEST_F(FileFlow, RecoveryIsAnsweredByKeys) {
  ui.recovery.entries = {{folder_ / "mine.json", "One", "", ""}, {{}, "Two", "", "broken"}};
  step(2);
  key(keys::down);
  key(keys::enter);
  EXPECT_FALSE(ui.requests.recovery) << "a broken one cannot be restored";
  key(keys::up);
  key(keys::enter);
  ASSERT_TRUE(ui.requests.recovery);
  EXPECT_EQ(ui.requests.recovery->kind, RecoveryAnswer::Kind::restore);
  EXPECT_EQ(ui.requests.recovery->index, 0u);
  ui.requests.recovery.reset();
  key(keys::escape);
  ASSERT_TRUE(ui.requests.recovery);
  EXPECT_EQ(ui.requests.recovery->kind, RecoveryAnswer::Kind::later);
}

TEST_F(FileFlow, NothingIsSavedOverWhatTheLevelIsReadFrom) {
  fs::copy_file(std::string(ANAMORPH_TEST_DATA) + "/meshes/cube.obj", folder_ / "b.obj");
  fs::create_hard_link(folder_ / "b.obj", folder_ / "hard.obj");
  fs::create_symlink("b.obj", folder_ / "mesh.json");
  Level level = editor.session.level();
  level.original.shape = FileShape{"b.obj"};
  editor.session.edit(level);
  testing::saveTo(editor.session, folder_ / "mine.json");
  const FilePurpose sculpture = FilePurpose::toSave(formatOf(ExportKind::sculpture));
  const FilePurpose report = FilePurpose::toSave(formatOf(ExportKind::matchReport));
  const std::tuple<FilePurpose, const char*, bool> cases[] = {
      {sculpture, "b.obj", false},    {sculpture, "hard.obj", false},
      {sculpture, "./b.obj", false},  {report, "mine.json", false},
      {sculpture, "other.obj", true}, {FilePurpose::saveLevel, "mesh.json", false}};
  for (const auto& [purpose, name, allowed] : cases) {
    browseFiles(ui.browser, purpose, folder_ / "proposed");
    step(3);
    type(name);
    key(keys::enter);
    EXPECT_EQ(!ui.browser.open, allowed) << name;
    EXPECT_EQ(ui.browser.problem.find("the open level is read from this file") != std::string::npos, !allowed)
        << name;
    EXPECT_TRUE(ui.browser.replace.empty()) << name << ": it is not even asked";
    ui.browser.open = false;
    step(2);
  }
  browseFiles(ui.browser, FilePurpose::saveLevel, folder_ / "mine.json");
  step(3);
  key(keys::enter);
  EXPECT_EQ(ui.browser.replace, fs::path(folder_ / "mine.json")) << "a level goes over its own file";
}

}  // namespace
}  // namespace anamorph::testing
