#include "level/lesson.h"

#include <string>

#include <gtest/gtest.h>

#include "error_text.h"
#include "level/level_json.h"

namespace anamorph {
namespace {

std::string lessonWith(const std::string& more, const std::string& done = "[]",
                       const std::string& show = "{}") {
  return R"({"id": "l", "steps": [{"id": "s", "title": "T", "why": "W", "do": "D", "done": )" + done +
         R"(, "show": )" + show + more + "}]}";
}

TEST(LessonJson, WithoutTextThereAreNoSteps) {
  EXPECT_EQ(parseLesson("", "l.json"), Lesson{});
}

TEST(LessonJson, ReadsEveryField) {
  const Lesson lesson = parseLesson(R"({"id": "l", "badge": {"title": "B", "text": "C"}, "steps": [
    {"id": "s", "title": "T", "why": "W", "do": "D", "notice": "N", "figure": "construction", "optional": true,
     "done": [{"when": "viewed", "what": "difference"}, {"when": "matchBelow", "value": 0.5}],
     "ask": {"text": "Q", "answers": [{"text": "A", "reply": "No"}, {"text": "B", "reply": "Yes", "right": true}]},
     "start": {"eye": [0, 1, 2], "putRight": ["normal", "distance"]},
     "show": {"tab": "rays", "widget": "Show", "play": {
       "eye": [1, 2, 3], "original": [4, 5, 6], "mirror": [7, 8, 9], "depthScale": 2, "depthOffset": 3,
       "controlPoint": 4, "controlBy": [0, 0.5, 0], "tolerance": "off",
       "fovDegrees": 30, "morph": 0.25, "viewEye": [1, 1, 1], "viewTarget": [2, 2, 2], "wipe": 0.75, "vertex": 7,
       "ends": [8, 9], "pixel": [3, 4], "preview": "wipe", "rays": "pixels", "putRight": "normal", "shape": "pawn",
       "segments": 5, "mirrorKind": "sphere", "lookThrough": true, "animate": true, "wireframe": true, "caustic": true, "undo": true,
       "freeze": true}}}]})",
                                    "l.json");
  Lesson expected{"l", {"B", "C"}, {}};
  LessonStep step{"s", "T", "W", "D", "N", "construction", true, {}, {"rays", "Show", StepMove{}}, {}, {}};
  step.done = {{StepEvent::viewed, 0, "difference"}, {StepEvent::matchBelow, 0.5, ""}};
  StepMove& move = *step.show.play;
  move = {Point(1, 2, 3),
          Point(4, 5, 6),
          Point(7, 8, 9),
          2,
          3,
          4,
          Vector(0, 0.5, 0),
          0,
          30,
          0.25,
          Point(1),
          Point(2),
          0.75,
          7,
          std::array{8, 9},
          std::array{3, 4},
          "wipe",
          "pixels",
          {"normal"},
          "pawn",
          5,
          "sphere",
          true,
          true,
          true,
          true,
          true,
          true};
  step.question = StepQuestion{"Q", {{"A", "No", false}, {"B", "Yes", true}}};
  step.start.eye = Point(0, 1, 2);
  step.start.putRight = {"normal", "distance"};
  expected.steps = {step};
  EXPECT_EQ(lesson, expected);
}

TEST(LessonJson, EveryEventHasItsName) {
  for (std::size_t i = 0; i < stepEvents.size(); ++i) {
    std::string done = std::string(R"([{"when": ")") + stepEvents[i] + "\"";
    const std::string withValue = done + R"(, "value": 0.5}])";
    const std::string error = errorOf([&] { parseLesson(lessonWith("", done + "}]"), "l.json"); });
    const auto parsed = [&](const std::string& text) {
      return static_cast<std::size_t>(parseLesson(lessonWith("", text), "l.json").steps[0].done[0].when);
    };
    if (error == "no error") {
      EXPECT_EQ(parsed(done + "}]"), i);
    } else if (error.find("\"value\"") != std::string::npos) {
      EXPECT_EQ(parsed(withValue), i);
    } else {
      EXPECT_NE(error.find("\"what\""), std::string::npos) << stepEvents[i] << error;
    }
  }
}

struct BadLesson {
  const char* name;
  std::string json;
  const char* message;
};
class BadLessonText : public ::testing::TestWithParam<BadLesson> {};

TEST_P(BadLessonText, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(withoutPlaces(errorOf([&] { parseLesson(GetParam().json, "l.json"); })),
            std::string("l.json: ") + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Lessons, BadLessonText,
    ::testing::Values(
        BadLesson{"NotAnObject", "[]", "/lesson: expected an object, got []"},
        BadLesson{"NoId", R"({"steps": []})", "/lesson: expected the key \"id\", got an object without it"},
        BadLesson{"EmptyId", R"({"id": "", "steps": []})",
                  "/lesson/id: expected a name that is not empty, got \"\""},
        BadLesson{"StepWithoutTask", R"({"id": "l", "steps": [{"id": "s", "title": "", "why": ""}]})",
                  "/lesson/steps/0: expected the key \"do\", got an object without it"},
        BadLesson{"UnknownKey", lessonWith(R"(, "hint": "x")"),
                  "/lesson/steps/0/hint: expected a key that is known here, got \"hint\""},
        BadLesson{"UnknownFigure", lessonWith(R"(, "figure": "cat")"),
                  "/lesson/steps/0/figure: expected \"perspective\", \"construction\", \"columns\", "
                  "\"edges\" or \"occlusion\", got \"cat\""},
        BadLesson{"ValueMissing", lessonWith("", R"([{"when": "matchAbove"}])"),
                  "/lesson/steps/0/done/0: expected the key \"value\", got an object without it"},
        BadLesson{"ValueTooLarge", lessonWith("", R"([{"when": "matchAbove", "value": 99}])"),
                  "/lesson/steps/0/done/0/value: expected a number from 0 to 1, got 99"},
        BadLesson{"ValueWhereNoneIs", lessonWith("", R"([{"when": "movedEye", "value": 1}])"),
                  "/lesson/steps/0/done/0/value: expected a key that is known here, got \"value\""},
        BadLesson{"UnknownTab", lessonWith("", R"([{"when": "viewed", "what": "cat"}])"),
                  "/lesson/steps/0/done/0/what: expected \"reflection\", \"original\", \"difference\" or "
                  "\"wipe\", got \"cat\""},
        BadLesson{"PlayedNowhere", lessonWith("", "[]", R"({"play": {"eye": [1, 2]}})"),
                  "/lesson/steps/0/show/play/eye: expected an array of 3 numbers, got [1, 2]"},
        BadLesson{"NoRightAnswer",
                  lessonWith(R"(, "ask": {"text": "Q", "answers": [{"text": "A", "reply": "R"}]})"),
                  "/lesson/steps/0/ask/answers: expected answers of which one is right, "
                  "got [{\"text\": \"A\", \"reply\": \"R\"}]"},
        BadLesson{
            "StartsByUndoing", lessonWith(R"(, "start": {"undo": true})"),
            "/lesson/steps/0/start: expected a move without morph, wipe, shape and undo, got an object"},
        BadLesson{
            "PutsRightNothingKnown", lessonWith("", "[]", R"({"play": {"putRight": ["normal", "cat"]}})"),
            "/lesson/steps/0/show/play/putRight: expected \"direction\", \"distance\" or \"normal\", or "
            "an array of some of them, got [\"normal\", \"cat\"]"},
        BadLesson{"SameIdTwice",
                  R"({"id": "l", "steps": [{"id": "s", "title": "", "why": "", "do": ""},
                                           {"id": "s", "title": "", "why": "", "do": ""}]})",
                  "/lesson/steps/1/id: expected an id of its own, got \"s\" again"}),
    [](const auto& bad) { return bad.param.name; });

TEST(LessonJson, AnUnknownEventNamesAllThatThereAre) {
  const std::string error =
      withoutPlaces(errorOf([] { parseLesson(lessonWith("", R"([{"when": "jumped"}])"), "l.json"); }));
  EXPECT_EQ(error.find("l.json: /lesson/steps/0/done/0/when: expected \"movedEye\", "), 0u) << error;
  EXPECT_NE(error.find("got \"jumped\""), std::string::npos);
}

// There is no file that it could be made of.
TEST(LessonJson, AMirrorOfAFileIsNoKindThatAMoveCanMake) {
  const std::string expected = "expected \"plane\", \"cylinder\"";
  const auto errorIn = [](const std::string& done, const std::string& show) {
    return withoutPlaces(errorOf([&] { parseLesson(lessonWith("", done, show), "l.json"); }));
  };
  const std::string play = errorIn("[]", R"({"play": {"mirrorKind": "mesh"}})");
  EXPECT_EQ(play.find("l.json: /lesson/steps/0/show/play/mirrorKind: " + expected), 0u) << play;
  const std::string done = errorIn(R"([{"when": "changedMirror", "what": "mesh"}])", "{}");
  EXPECT_EQ(done.find("l.json: /lesson/steps/0/done/0/what: " + expected), 0u) << done;
  EXPECT_EQ(errorIn("[]", R"({"play": {"mirrorKind": "patch"}})"), "no error");
}

TEST(LessonJson, ALevelWithABadLessonIsRefused) {
  Level level;
  level.text.edit([&](LevelText& text) { text.lesson = R"({"id": "l", "steps": 3})"; });
  EXPECT_EQ(withoutPlaces(errorOf([&] { parseLevel(formatLevel(level), "x.json"); })),
            "x.json: /lesson/steps: expected an array, got 3");
}

}  // namespace
}  // namespace anamorph
