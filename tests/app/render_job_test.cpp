// The large picture: made and saved without one being in the other's way.

#include "app/render_job.h"

#include <chrono>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "gui_fixture.h"

namespace anamorph {
namespace {

using namespace anamorph::testing;

class RenderWindow : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (!headless) return;
    openSmallLevel();
    ui().render.open = true;
    ui().render.longerSide = 64;
    framesWhile([&] { return !editor().updater.result().original.mesh; });
    ui().requests.startRender = true;
    frames(1);
    wait();
    ASSERT_NE(ui().textures.render.id, 0u);
  }
  void wait() {
    framesWhile([&] { return ui().render.running || !ui().render.saving.empty(); });
    frames(1);
  }
  void save(const std::string& name) { ui().requests.saveRender = folder / name; }

  TemporaryFolder folder;
};

TEST_F(RenderWindow, ThatRendersAnewWhileItSavesDoesBoth) {
  for (int i = 0; i < 5; ++i) {
    const std::string name = std::to_string(i) + ".png";
    save(name);
    frames(1);
    ui().requests.startRender = true;
    frames(1);
    wait();
    EXPECT_TRUE(std::filesystem::exists(folder / name)) << ui().render.message;
    // A save that was done before the new picture was begun has been said by then.
    const std::string& said = ui().render.message;
    EXPECT_TRUE(said.empty() || said.find(name) != std::string::npos) << said;
  }
}

TEST_F(RenderWindow, SavesAllThatItWasAskedFor) {
  for (int i = 0; i < 5; ++i) {
    save(std::to_string(i) + ".png");
    frames(1);
  }
  wait();
  EXPECT_EQ(folder.fileCount(), 5u);
}

TEST_F(RenderWindow, SaysWhatCouldNotBeSavedAndDoesNotQuitThen) {
  save("no such folder/picture.png");
  ui().finish = FinishQuestion{FinishQuestion::Answer::wait};
  frames(1);
  wait();
  EXPECT_NE(ui().render.message.find("No such file"), std::string::npos) << ui().render.message;
  EXPECT_FALSE(ui().requests.quit);
  ASSERT_TRUE(ui().notice);
  EXPECT_NE(ui().notice->text.find("picture.png"), std::string::npos);
}

}  // namespace
}  // namespace anamorph
