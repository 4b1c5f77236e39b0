#include "level/lesson_check.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/error.h"
#include "error_text.h"
#include "level/level_library.h"
#include "level/limits.h"

namespace anamorph {
namespace {

constexpr std::size_t vertices = 100;

std::vector<std::string> faultsOf(const LoadedLevel& loaded) {
  FileRemarks remarks("l.json");
  checkLesson(loaded, vertices, remarks);
  try {
    remarks.throwFaults();
  } catch (const Error& error) {
    return linesOf(error);
  }
  return {};
}

// A level with one step.
std::string faultOf(const std::string& done, const std::string& show) {
  const std::string text = R"({"format": "anamorph-level", "version": 1,
    "optic": {"kind": "mirror", "shape": {"type": "sphere", "centre": [0, 0, 0], "radius": 2}},
    "camera": {"eye": [0, -9, 3], "target": [0, 5, 1]}, "original": {"shape": {"type": "box"}},
    "sculpture": {"depthScale": 0.5, "mistakes": {"normal": true}},
    "lesson": {"id": "l", "steps": [{"id": "s", "title": "T", "why": "W", "do": "D",
      "done": )" + done + R"(,
      "show": )" + show + "}]}}";
  const std::vector<std::string> faults = faultsOf(parseLevel(text, "l.json"));
  return faults.empty() ? "" : faults[0];
}

TEST(LessonCheck, InstalledLessonsHaveNoFaults) {
  for (const LevelEntry& entry : listLevels(ANAMORPH_LEVELS)) {
    FileRemarks remarks(entry.name);
    checkLesson(loadLevel(entry.path), static_cast<std::size_t>(limits::vertexNumber.max), remarks);
    EXPECT_EQ(errorOf([&] { remarks.throwFaults(); }), "no error");
  }
}

TEST(LessonCheck, FindsAMisspeltControl) {
  EXPECT_EQ(faultOf("[]", R"({"tab": "sculpture", "widget": "Depth scale k"})"), "");
  EXPECT_EQ(
      faultOf("[]", R"({"tab": "sculpture", "widget": "Depth sclae k"})"),
      "l.json: line 7, column 46: /lesson/steps/0/show/widget: expected the English name of a control, got "
      "\"Depth sclae k\"; did you mean \"Depth scale k\"?");
}

TEST(LessonCheck, FindsVerticesAndPixelsThatThereAreNot) {
  EXPECT_EQ(faultOf("[]", R"({"play": {"vertex": 99, "pixel": [7, 7]}})"), "");
  EXPECT_EQ(faultOf("[]", R"({"play": {"vertex": 100}})"),
            "l.json: line 7, column 35: /lesson/steps/0/show/play/vertex: expected one of the original's "
            "vertices, 0 "
            "to 99, got 100");
  EXPECT_EQ(faultOf("[]", R"({"play": {"pixel": [7, 8]}})"),
            "l.json: line 7, column 34: /lesson/steps/0/show/play/pixel: expected a pixel of the grid of 8 x "
            "8, got "
            "[7, 8]");
}

TEST(LessonCheck, KnowsTheMirrorThatAMoveMakes) {
  const char* last = R"("controlPoint": 35, "controlBy": [0, -1, 0])";
  const char* none = R"("controlPoint": 36, "controlBy": [0, -1, 0])";
  const char* kind = R"("mirrorKind": "patch")";
  const auto faultOfMoves = [](const std::string& play, const std::string& start) {
    return withoutPlaces(faultOf("[]", "{\"play\": {" + play + "}}, \"start\": {" + start + "}"));
  };
  const auto with = [](const char* a, const char* b) { return std::string(a) + ", " + b; };
  EXPECT_EQ(faultOfMoves(with(kind, last), ""), "");
  EXPECT_EQ(faultOfMoves(last, kind), "") << "as the step begins";
  EXPECT_EQ(faultOfMoves("", with(kind, last)), "");
  EXPECT_EQ(faultOfMoves(last, "").find(
                "l.json: /lesson/steps/0/show/play/controlPoint: expected no control point"),
            0u);
  EXPECT_EQ(
      faultOfMoves(with(kind, none), "").find("l.json: /lesson/steps/0/show/play/controlPoint: expected one"),
      0u);
  EXPECT_EQ(
      faultOfMoves("", last).find("l.json: /lesson/steps/0/start/controlPoint: expected no control point"),
      0u);
}

struct Move {
  const char *done, *play;
  bool meets;
};

TEST(LessonCheck, FindsMovesAfterWhichTheStepCannotBeDone) {
  for (const Move& move : {Move{R"("movedEye")", R"("eye": [1, -9, 3])", true},
                           Move{R"("movedEye")", R"("eye": [0, -9, 3])", false},
                           Move{R"("movedEye")", R"("depthScale": 2)", false},
                           Move{R"("movedOriginal")", R"("original": [1, 2, 3])", true},
                           Move{R"("movedMirror")", R"("mirrorKind": "cone")", true},
                           Move{R"("movedMirror")", R"("mirrorKind": "sphere")", false},
                           Move{R"("movedMirror")", R"("mirror": [1, 2, 3])", true},
                           Move{R"("movedMirror")", R"("original": [1, 2, 3])", false},
                           Move{R"("changedOriginal")", R"("segments": 1)", true},
                           Move{R"("changedOriginal")", R"("shape": "pawn")", true},
                           Move{R"("changedOriginal")", R"("eye": [1, 2, 3])", false},
                           Move{R"("changedMirror", "what": "cone")", R"("mirrorKind": "cone")", true},
                           Move{R"("changedMirror", "what": "cone")", R"("mirrorKind": "plane")", false},
                           Move{R"("depthScaleChanged")", R"("depthScale": 0.5)", false},
                           Move{R"("depthScaleChanged")", R"("depthScale": 0.6)", true},
                           Move{R"("toleranceOff")", R"("tolerance": "off")", true},
                           Move{R"("toleranceOff")", R"("tolerance": 0.5)", false},
                           Move{R"("toleranceOn")", R"("tolerance": "off")", false},
                           Move{R"("pickedVertex")", R"("pixel": [1, 1])", false},
                           Move{R"("pickedPixel")", R"("pixel": [1, 1])", true},
                           Move{R"("viewed", "what": "wipe")", R"("preview": "wipe")", true},
                           Move{R"("viewed", "what": "wipe")", R"("preview": "original")", false},
                           Move{R"("lookedThrough")", R"("lookThrough": true)", true},
                           Move{R"("lookedThrough")", R"("viewEye": [1, 1, 1])", false},
                           Move{R"("rotatedView")", R"("viewEye": [1, 1, 1])", true},
                           Move{R"("morphed")", R"("morph": 0.2)", true},
                           Move{R"("morphed")", R"("morph": 0.7)", false},
                           Move{R"("raysOf", "what": "pixels")", R"("rays": "vertices")", false},
                           Move{R"("animatedRays")", R"("animate": true)", true},
                           Move{R"("wireframe")", R"("animate": true)", false},
                           Move{R"("putRight", "what": "normal")", R"("putRight": "normal")", true},
                           Move{R"("putRight", "what": "normal")", R"("putRight": "distance")", false},
                           Move{R"("undone")", R"("undo": true)", true},
                           Move{R"("exported")", R"("undo": true)", false},
                           Move{R"("matchAbove", "value": 0.5)", R"("putRight": "normal")", true}}) {
    const std::string fault = withoutPlaces(faultOf(std::string("[{\"when\": ") + move.done + "}]",
                                                    std::string("{\"play\": {") + move.play + "}}"));
    const std::string expected =
        "l.json: /lesson/steps/0/show/play: expected a move after which its step is done";
    EXPECT_EQ(fault.find(expected) == 0, !move.meets) << move.done << " " << move.play << ": " << fault;
    EXPECT_EQ(fault.empty(), move.meets);
  }
}

}  // namespace
}  // namespace anamorph
