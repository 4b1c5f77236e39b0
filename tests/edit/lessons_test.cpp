// The lessons of the installed levels, worked through as a student would who asks to be shown every move, and as a
// lecturer who jumps: nothing is done by itself, everything is done by its move, every step has one beginning, and the
// texts are there in full.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "edit/advance.h"
#include "edit/editor.h"
#include "edit/lesson_run.h"
#include "edit/lesson_start.h"
#include "level/level_json.h"
#include "level/level_library.h"

namespace anamorph {
namespace {

struct InstalledLesson {
  std::string name;
  std::filesystem::path path;
  Lesson lesson;
};

// For messages of tests.
void PrintTo(const InstalledLesson& lesson, std::ostream* out) {
  *out << lesson.name;
}

std::vector<InstalledLesson> installedLessons() {
  std::vector<InstalledLesson> lessons;
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    const Level level = loadLevel(entry.path).level;
    lessons.push_back({entry.name, entry.path, parseLesson(level.text->lesson, entry.name)});
  }
  return lessons;
}

std::string alphanumeric(std::string text) {
  std::erase_if(text, [](unsigned char c) { return std::isalnum(c) == 0; });
  return text;
}

// Whether a step waits for something that is only known when everything has been computed.
bool needsResult(const LessonStep& step) {
  return std::any_of(step.done.begin(), step.done.end(), [](const StepCondition& condition) {
    return condition.when == StepEvent::matchAbove || condition.when == StepEvent::matchBelow ||
           condition.when == StepEvent::hiddenShareAbove || condition.when == StepEvent::hiddenShareBelow ||
           condition.when == StepEvent::foldedShareAbove || condition.when == StepEvent::foldedShareBelow ||
           condition.when == StepEvent::verticesBelow;
  });
}

// Frames until nothing moves, and until all is computed if the step waits for that.
void rest(Editor& editor, const LessonStep& step) {
  do {
    advance(editor, 0.05);
  } while (editor.flight || editor.lesson.play);
  if (needsResult(step)) editor.updater.finish(editor.session, {editor.preview.size, false});
  advance(editor, 0.01);
}

// The move of the open step; what a move cannot do is done here.
void makeMove(Editor& editor) {
  const LessonStep step = editor.lesson.open();
  playStep(editor);
  for (const StepCondition& condition : step.done) {
    if (condition.when == StepEvent::exported) ++editor.exported;  // tests/panels export real files
  }
  rest(editor, step);
}

void open(Editor& editor, const InstalledLesson& lesson) {
  openLevel(editor, lesson.path);
  editor.preview.size = 16;
  editor.updater.finish(editor.session, {editor.preview.size, false});
  rest(editor, {});
}

// One step; the names are those of the tests.
struct Case {
  InstalledLesson lesson;
  std::size_t step = 0;
};

void PrintTo(const Case& step, std::ostream* out) {
  *out << step.lesson.name << ", step " << step.step;
}

std::vector<Case> allSteps() {
  std::vector<Case> cases;
  for (const InstalledLesson& lesson : installedLessons()) {
    for (std::size_t i = 0; i < lesson.lesson.steps.size(); ++i) cases.push_back({lesson, i});
  }
  return cases;
}

std::string nameOf(const testing::TestParamInfo<Case>& info) {
  const auto& [lesson, step] = info.param;
  return alphanumeric(lesson.name) + "_" + alphanumeric(lesson.lesson.steps[step].id);
}

class StepTest : public testing::TestWithParam<Case> {
 protected:
  Editor editor{{}, 2};
};

TEST_P(StepTest, IsDoneByItsMoveAndNotBefore) {
  const auto& [lesson, index] = GetParam();
  open(editor, lesson);
  openStep(editor, index);
  const LessonStep& step = editor.lesson.open();
  rest(editor, step);
  rest(editor, step);
  ASSERT_FALSE(editor.lesson.done) << "before anything is done";
  if (step.done.empty()) {
    nextStep(editor);
  } else {
    makeMove(editor);
    EXPECT_TRUE(editor.lesson.done);
  }
  EXPECT_TRUE(isDone(editor.lesson.lesson, step, editor.progress));
}

// From every other step, whatever was done there.
TEST_P(StepTest, BeginsAlikeFromEverywhere) {
  const auto& [lesson, index] = GetParam();
  open(editor, lesson);
  openStep(editor, index);
  rest(editor, {});
  const Level wanted = editor.session.level();
  const ViewPose pose = editor.pose;
  const PreviewTab tab = editor.preview.tab;
  for (std::size_t from = 0; from < lesson.lesson.steps.size(); ++from) {
    openStep(editor, from);
    playStep(editor);
    finishPlay(editor);
    openStep(editor, index);
    rest(editor, {});
    EXPECT_EQ(editor.session.level(), wanted) << "from step " << from;
    EXPECT_EQ(editor.pose, pose) << "from step " << from;
    EXPECT_EQ(editor.preview.tab, tab) << "from step " << from;
    EXPECT_FALSE(editor.point || editor.cell || editor.rays.animate || editor.display.wireframe);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, StepTest, testing::ValuesIn(allSteps()), nameOf);

class LessonTest : public testing::TestWithParam<InstalledLesson> {
 protected:
  const Lesson& lesson() const { return GetParam().lesson; }
};

TEST_P(LessonTest, IsWorkedThroughFromBeginningToEnd) {
  Editor editor({}, 2);
  open(editor, GetParam());
  ASSERT_FALSE(editor.lesson.empty());
  for (std::size_t i = 0; i < lesson().steps.size(); ++i) {
    const LessonStep step = editor.lesson.open();
    SCOPED_TRACE(step.id);
    ASSERT_EQ(editor.lesson.step, i);
    if (isStartMissed(editor.lesson, editor.session.level())) openStep(editor, i);  // as it is offered
    rest(editor, step);
    ASSERT_FALSE(editor.lesson.done);
    EXPECT_FALSE(scoreOf(lesson(), editor.progress).badge && !step.optional);
    if (!step.done.empty()) makeMove(editor);
    ASSERT_TRUE(editor.lesson.done || step.done.empty());
    nextStep(editor);
  }
  const LessonScore score = scoreOf(lesson(), editor.progress);
  EXPECT_EQ(score.points, score.of);
  EXPECT_TRUE(score.badge);
}

TEST_P(LessonTest, CanBeShown) {
  for (const LessonStep& step : lesson().steps) {
    SCOPED_TRACE(step.id);
    const bool exports = std::any_of(step.done.begin(), step.done.end(),
                                     [](const StepCondition& c) { return c.when == StepEvent::exported; });
    EXPECT_TRUE(step.show.play || step.done.empty() || exports);
    EXPECT_FALSE(step.show.widget.empty()) << "Where? outlines something";
    if (!step.show.play) continue;
    const StepMove& move = *step.show.play;
    const bool changesLevel = move.eye || move.original || move.mirror || move.depthScale ||
                              move.tolerancePixels || move.fovDegrees || move.segments ||
                              !move.putRight.empty() || !move.shape.empty() || !move.mirrorKind.empty();
    EXPECT_TRUE(!changesLevel || (!step.show.tab.empty() && !step.show.widget.empty()))
        << "a number that is changed has a control";
  }
}

TEST_P(LessonTest, IsShortAndComplete) {
  EXPECT_FALSE(lesson().badge.title.empty());
  EXPECT_FALSE(lesson().badge.text.empty());
  EXPECT_GE(lesson().steps.size(), 4u);
  EXPECT_LE(lesson().steps.size(), 8u);
  for (const LessonStep& step : lesson().steps) {
    SCOPED_TRACE(step.id);
    for (const std::string& text : {step.title, step.why, step.task, step.notice}) {
      EXPECT_FALSE(text.empty());
      EXPECT_EQ(text.find('!'), std::string::npos) << text;
      EXPECT_EQ(text.find("  "), std::string::npos) << text;
    }
    for (const std::string& text : {step.why, step.task, step.notice}) {
      EXPECT_TRUE(text.ends_with('.') || text.ends_with('?')) << text;
    }
    std::istringstream words(step.why + " " + step.task + " " + step.notice);
    EXPECT_LE(std::distance(std::istream_iterator<std::string>(words), {}), 95);
  }
}

INSTANTIATE_TEST_SUITE_P(Levels, LessonTest, testing::ValuesIn(installedLessons()),
                         [](const auto& lesson) { return alphanumeric(lesson.param.name); });

TEST(Lessons, HaveIdsAndBadgesOfTheirOwn) {
  std::set<std::string> ids, badges;
  const std::vector<InstalledLesson> lessons = installedLessons();
  for (const InstalledLesson& lesson : lessons) {
    ids.insert(lesson.lesson.id);
    badges.insert(lesson.lesson.badge.title);
  }
  EXPECT_EQ(ids.size(), lessons.size());
  EXPECT_EQ(badges.size(), lessons.size());
  EXPECT_EQ(ids, (std::set<std::string>{"perspective", "plane", "cylinder", "sphere", "mistakes", "cone",
                                        "hollow", "free-form", "sandbox"}));
}

}  // namespace
}  // namespace anamorph
