// Exports from the window: always of the settled level, counted for the lesson; and pictures of the window.

#include <cstdlib>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "app/shot.h"
#include "cli/program.h"
#include "geometry/mesh_files.h"
#include "gl/texture.h"
#include "gui_fixture.h"
#include "panels/actions.h"
#include "raytrace/png.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

// All of a picture of the window at once.
Bitmap takeShot(Gui& gui, const ShotRequest& request) {
  Shot shot(gui, request);
  while (!shot.complete()) shot.draw(Piecework::noHurry);
  return compose(shot.takeLayers());
}

class ExportWindow : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (!headless) return;
    openSmallLevel();
    perform(Action::exportFiles, editor(), ui());
    frames(2);
  }
  void start(ExportKind kind, const std::string& path) {
    ui().exporting.kind = static_cast<int>(kind);
    ui().exporting.request.kind = kind;
    ui().exporting.request.path = path;
    ui().exporting.request.size = 64;
    ui().requests.startExport = true;
    frames(1);
  }
  void wait() {
    framesWhile([&] { return ui().exporting.running; });
    frames(2);
  }

  TemporaryFolder folder;
};

TEST_F(ExportWindow, WhatWasSaidOfAnEarlierLevelGoes) {
  ui().requests.checkPrint = true;
  frames(1);
  wait();
  ASSERT_NE(ui().exporting.message, "");
  ASSERT_FALSE(ui().exporting.rows.empty());
  Level level = editor().session.level();
  level.sculpture.depthScale *= 0.5;
  editor().session.edit(level);
  frames(1);
  EXPECT_EQ(ui().exporting.message, "");
  EXPECT_TRUE(ui().exporting.rows.empty());
}

TEST_F(ExportWindow, WritesEveryKindAndCountsIt) {
  const std::pair<ExportKind, const char*> files[] = {
      {ExportKind::sculpture, "s.stl"},    {ExportKind::viewingSheet, "s.pdf"},
      {ExportKind::viewingSheet, "s.svg"}, {ExportKind::rays, "r.obj"},
      {ExportKind::matchReport, "m.html"}, {ExportKind::matchReport, "m.json"},
      {ExportKind::picture, "p.png"}};
  int count = 0;
  for (const auto& [kind, name] : files) {
    SCOPED_TRACE(name);
    start(kind, folder / name);
    wait();
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << ui().exporting.message;
    EXPECT_EQ(editor().exported, ++count);
    EXPECT_NE(ui().exporting.message.find(name), std::string::npos) << ui().exporting.message;
  }
}

TEST_F(ExportWindow, WaitsUntilADragHasRefined) {
  Level level = editor().session.level();
  level.sculpture.depthScale = 0.5;
  editor().session.change(level);  // a drag goes on
  start(ExportKind::sculpture, folder / "s.ply");
  EXPECT_TRUE(ui().exporting.running);
  EXPECT_FALSE(std::filesystem::exists(folder / "s.ply"));
  editor().session.finishChange();
  wait();
  ASSERT_TRUE(std::filesystem::exists(folder / "s.ply"));
  const LevelResult& result = editor().updater.result();
  EXPECT_EQ(loadMesh(folder / "s.ply").mesh.triangles.size(),
            result.sculpture.sculpture->mesh.triangles.size());
}

TEST_F(ExportWindow, FaultsAndCancellingLeaveNothing) {
  start(ExportKind::sculpture, folder / "no/such/folder/s.stl");
  wait();
  EXPECT_NE(ui().exporting.message.find("no/such/folder"), std::string::npos) << ui().exporting.message;
  Level level = editor().session.level();
  level.camera.eye = {0, 0, 1};  // in the mirror's plane
  editor().session.edit(level);
  start(ExportKind::sculpture, folder / "s.stl");
  wait();
  EXPECT_EQ(ui().exporting.message, "There is no sculpture to export.");
  editor().session.undo();
  start(ExportKind::matchReport, folder / "m.html");
  ui().requests.cancelExport = true;
  frames(1);
  wait();
  EXPECT_EQ(ui().exporting.message, "Cancelled. Nothing was written.");
  EXPECT_EQ(folder.fileCount(), 0u);
  EXPECT_EQ(editor().exported, 0);
}

TEST_F(ExportWindow, BeginsAnewWhatWasCancelledBefore) {
  Level level = editor().session.level();
  level.sculpture.depthScale = 0.5;
  editor().session.edit(level);
  frames(1);
  editor().updater.cancel();
  start(ExportKind::sculpture, folder / "s.stl");
  wait();
  EXPECT_TRUE(std::filesystem::exists(folder / "s.stl")) << ui().exporting.message;
}

TEST_F(ExportWindow, SaysCancelledOnlyWhenNothingWasWritten) {
  for (int pause = 0; pause < 12; ++pause) {
    const std::string path = folder / ("s" + std::to_string(pause) + ".stl");
    start(ExportKind::sculpture, path);
    std::this_thread::sleep_for(std::chrono::milliseconds(pause));
    ui().requests.cancelExport = true;
    frames(1);
    wait();
    const bool written = std::filesystem::exists(path);
    const std::string expected = written ? "Written: " : "Cancelled. Nothing was written.";
    EXPECT_EQ(ui().exporting.message.substr(0, expected.size()), expected);
  }
}

TEST_F(ExportWindow, ChecksForPrinting) {
  ui().requests.checkPrint = true;
  frames(1);
  wait();
  EXPECT_EQ(ui().exporting.message, "It can be printed.");
  ASSERT_FALSE(ui().exporting.rows.empty());
  EXPECT_EQ(ui().exporting.rows.front().first, "size");
}

TEST_F(ExportWindow, AShotTooLargeForTheGraphicsCardIsToldAndAll) {
  const Preferences preferences = ui().preferences;
  headless.reset();  // one Dear ImGui at a time
  headless = std::make_unique<HeadlessGui>(Texture::maxSize() / 4 + 8, 100, preferences, 1);
  gui().open(levelPath("1-plane"));
  frames(1);
  try {
    takeShot(gui(), {4, true, false, {}});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("too large for this graphics card"), std::string::npos);
  }
}

TEST_F(ExportWindow, ShotsAreAsLargeAsAskedForAndTheWindowGoesOn) {
  ui().exporting.open = false;  // windows that lie over each other may change their order
  headless->settle();
  const Bitmap before = headless->readBack();
  for (const int factor : {1, 2}) {
    for (const bool panels : {true, false}) {
      const Bitmap shot = takeShot(gui(), {factor, panels, false, {}});
      EXPECT_EQ(shot.width, 640 * factor);
      EXPECT_EQ(shot.height, 480 * factor);
      EXPECT_EQ(shot.bytes.size(), std::size_t{3} * shot.width * shot.height);
    }
  }
  const Bitmap transparent = takeShot(gui(), {1, false, true, {}});
  EXPECT_EQ(transparent.bytes[3], 0) << "the corner is sky";
  EXPECT_FALSE(ui().panelsHidden);
  headless->settle();
  const Bitmap after = headless->readBack();
  ASSERT_EQ(after.bytes.size(), before.bytes.size());
  std::size_t far = 0;
  for (std::size_t i = 0; i < after.bytes.size(); ++i) {
    far += std::abs(int(after.bytes[i]) - int(before.bytes[i])) > 8;
  }
  EXPECT_LT(far, after.bytes.size() / 200);
}

TEST_F(ExportWindow, ShotsAreDrawnFrameByFrameAndWritten) {
  headless->settle();
  const ShotRequest request{2, true, false, folder / "window.png"};
  const Bitmap expected = takeShot(gui(), request);
  headless->settle();
  const int exported = editor().exported;
  ui().requests.shot = request;
  const ViewQuality best = QualityGovernor::best();
  headless->frame(1.0 / 60, &best);
  EXPECT_TRUE(gui().unfinished());
  headless->frame(1.0 / 60, &best);
  EXPECT_TRUE(ui().exporting.running);
  wait();
  EXPECT_FALSE(ui().shot.running);
  EXPECT_NE(ui().exporting.message.find("window.png"), std::string::npos) << ui().exporting.message;
  EXPECT_EQ(editor().exported, exported + 1);
  EXPECT_EQ(loadPng(request.path), expected);
}

TEST_F(ExportWindow, ShotsCanBeCancelled) {
  headless->resize(1600, 1000);
  ui().requests.shot = ShotRequest{4, true, false, folder / "window.png"};
  frames(2);
  ASSERT_TRUE(ui().shot.running);
  ui().requests.cancelShot = true;
  frames(1);
  EXPECT_FALSE(ui().shot.running);
  EXPECT_NE(ui().exporting.message.find("Nothing was written"), std::string::npos);
  frames(2);
  EXPECT_FALSE(ui().exporting.running);
  EXPECT_EQ(folder.fileCount(), 0u);
}

TEST_F(ExportWindow, PanelsAreComposedOverTheView) {
  const auto pixel = [](std::initializer_list<std::uint8_t> rgba) { return Bitmap{1, 1, 4, rgba}; };
  EXPECT_EQ(compose({pixel({0, 0, 0, 0}), pixel({10, 20, 30, 255}), 0, 0, false}).bytes,
            (std::vector<std::uint8_t>{10, 20, 30}));
  EXPECT_EQ(compose({pixel({40, 50, 60, 255}), pixel({10, 20, 30, 255}), 0, 0, false}).bytes,
            (std::vector<std::uint8_t>{40, 50, 60}));
  EXPECT_EQ(compose({pixel({50, 0, 0, 128}), pixel({100, 100, 200, 255}), 0, 0, false}).bytes,
            (std::vector<std::uint8_t>{100, 50, 100}));
  EXPECT_EQ(compose({pixel({0, 0, 0, 0}), pixel({10, 20, 30, 255}), 1, 0, false}).bytes,
            (std::vector<std::uint8_t>{0, 0, 0}))
      << "beside the view";
  EXPECT_EQ(compose({pixel({0, 0, 0, 0}), pixel({200, 100, 0, 128}), 0, 0, true}).bytes,
            (std::vector<std::uint8_t>{199, 100, 0, 128}));
}

}  // namespace
}  // namespace anamorph
