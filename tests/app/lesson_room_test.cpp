// Whether what a lesson says can be read at once, with the fonts of the window: nothing has to be scrolled to.

#include <string>

#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "edit/lesson_run.h"
#include "gui_fixture.h"
#include "level/level_library.h"

namespace anamorph::testing {
namespace {

struct Screen {
  const char* name;
  int width, height;
  double scale;
  const char* language;
};

void PrintTo(const Screen& screen, std::ostream* out) {
  *out << screen.name;
}

class LessonRoom : public GuiTest, public ::testing::WithParamInterface<Screen> {
 protected:
  // Pixels of the step's text that are out of sight.
  static float hidden() {
    const ImGuiWindow* step = window();
    if (!step) ADD_FAILURE() << "there is no step";
    return step ? step->ScrollMax.y : 0;
  }

 public:
  // In which the step's text is.
  static const ImGuiWindow* window() {
    for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if (std::string(window->Name).starts_with("lesson/step")) return window;
    }
    return nullptr;
  }
};

TEST_P(LessonRoom, EveryTaskAndWhatIsToBeNoticedFit) {
  if (!headless) return;
  const Screen& screen = GetParam();
  headless->resize(screen.width, screen.height);
  ui().preferences.uiScale = screen.scale;
  ui().preferences.language = screen.language;
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    gui().open(entry.path);
    frames(2);
    for (std::size_t i = 0; i < editor().lesson.lesson.steps.size(); ++i) {
      SCOPED_TRACE(entry.name + ", step " + std::to_string(i + 1));
      openStep(editor(), i);
      frames(3);
      EXPECT_EQ(hidden(), 0) << "the task";
      const auto& question = editor().lesson.open().question;
      for (std::size_t answer = 0; question && answer < question->answers.size(); ++answer) {
        if (question->answers[answer].right) answerStep(editor(), answer);
      }
      editor().lesson.done = true;
      frames(3);
      EXPECT_EQ(hidden(), 0) << "what is to be noticed";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Screens, LessonRoom,
                         ::testing::Values(Screen{"Laptop", 1280, 800, 1, "en"},
                                           Screen{"LaptopInDutch", 1280, 800, 1, "nl"},
                                           Screen{"LargeScreen", 1920, 1080, 1, "en"}),
                         [](const auto& screen) { return screen.param.name; });

// At twice the size not all of a step has room, but what to do is never below the edge.
TEST_F(GuiTest, AtTwiceTheSizeTheTaskStaysInSight) {
  if (!headless) return;
  headless->resize(1280, 800);
  ui().preferences.uiScale = 2;
  for (const char* language : {"en", "nl"}) {
    ui().preferences.language = language;
    for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
      gui().open(entry.path);
      frames(2);
      for (std::size_t i = 0; i < editor().lesson.lesson.steps.size(); ++i) {
        SCOPED_TRACE(std::string(language) + ", " + entry.name + ", step " + std::to_string(i + 1));
        openStep(editor(), i);
        frames(4);
        const ImGuiWindow* step = LessonRoom::window();
        ASSERT_TRUE(step);
        EXPECT_TRUE(step->ScrollMax.y == 0 || ui().lessonScroll.taskPinned || !isAnswered(editor().lesson));
        EXPECT_GT(step->Size.y, 100) << "why is read above it";
        EXPECT_LE(step->Pos.y + step->Size.y, 800);
      }
    }
  }
}

TEST_F(GuiTest, RaysThatArePausedSaySoAndGoOnFromTheEndByBeginningAnew) {
  if (!headless) return;
  headless->resize(1280, 800);
  openSmallLevel();
  framesWhile([&] { return !editor().updater.result().complete; });
  editor().rays.animate = true;
  editor().rays.loop = false;
  headless->frame(1e4, &draft);
  frames(1);
  EXPECT_TRUE(editor().animationPaused) << "at the end";
  const ImGuiWindow* hint = ImGui::FindWindowByName("##paused");
  ASSERT_TRUE(hint);
  EXPECT_TRUE(hint->WasActive);
  editor().animationPaused = false;  // Space
  frames(2);
  EXPECT_FALSE(editor().animationPaused);
  EXPECT_LT(editor().animationSeconds, 1);
}

}  // namespace
}  // namespace anamorph::testing
