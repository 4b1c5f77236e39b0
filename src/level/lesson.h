// A lesson: the steps that a level leads its student through, as data in the level file. A step says how it begins, why,
// what to do and what to notice; it may ask something first. It is done when what it waits for has been observed
// (edit/lesson_run.h), and it can show how: by pointing at a control or a thing, and by making the move itself.
//
//   "lesson": {
//     "id": "plane",
//     "badge": {"title": "...", "text": "..."},
//     "steps": [{"id": "aside", "title": "...", "why": "...", "do": "...", "notice": "...",
//                "start": {"depthScale": 1}, "done": [{"when": "movedEye"}],
//                "show": {"tab": "eye", "widget": "Position", "play": {"eye": [3, -11, 6.5]}}}]
//   }
//
// The vocabulary is small and checked: what is not in it is an Error with its place. levels/README.md
// explains all of it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "level/file_remarks.h"
#include "level/json.h"
#include "math/vec.h"

namespace anamorph {

/// What a step can wait for. Those with a value or a name say so; isState() tells states from events.
enum class StepEvent {
  movedEye,
  movedOriginal,    ///< or turned, or scaled
  movedMirror,      ///< or its size
  changedOriginal,  ///< another shape or file
  changedMirror,    ///< what: a name of mirrorKinds()
  depthScaleChanged,
  toleranceOff,
  toleranceOn,
  pickedPixel,
  pickedVertex,
  viewed,  ///< what: "reflection", "original", "difference", "wipe"
  lookedThrough,
  rotatedView,  ///< the 3D view, by more than 20 degrees
  lookedDown,   ///< the 3D view, so many degrees below the horizon: value
  morphed,      ///< the slider was moved to below a half
  raysOf,       ///< what: "pixels", "vertices"
  animatedRays,
  wireframe,   ///< triangle edges are shown
  matchAbove,  ///< value: silhouette IoU, 0..1
  matchBelow,
  hiddenShareAbove,  ///< value: 0..1
  hiddenShareBelow,
  putRight,  ///< what: "direction", "distance", "normal"
  undone,
  exported,
  eyeAbove,  ///< value: a height, z
  eyeAway,   ///< value: a distance from the middle of the optic's shape
  keptEye,   ///< it is where it was when the step began
  depthScaleAbove,
  depthScaleBelow,
  depthOffsetAbove,  ///< value: scene units
  depthOffsetBelow,
  foldedShareAbove,  ///< value: 0..1
  foldedShareBelow,
  caustic,        ///< it is shown
  verticesBelow,  ///< value: the original has fewer
  pickedEnds,     ///< two vertices, farther apart than half the original is long
  wiped,          ///< the line of the preview's tab was dragged
  frozen,         ///< the sculpture
};
inline constexpr std::array stepEvents{"movedEye",
                                       "movedOriginal",
                                       "movedMirror",
                                       "changedOriginal",
                                       "changedMirror",
                                       "depthScaleChanged",
                                       "toleranceOff",
                                       "toleranceOn",
                                       "pickedPixel",
                                       "pickedVertex",
                                       "viewed",
                                       "lookedThrough",
                                       "rotatedView",
                                       "lookedDown",
                                       "morphed",
                                       "raysOf",
                                       "animatedRays",
                                       "wireframe",
                                       "matchAbove",
                                       "matchBelow",
                                       "hiddenShareAbove",
                                       "hiddenShareBelow",
                                       "putRight",
                                       "undone",
                                       "exported",
                                       "eyeAbove",
                                       "eyeAway",
                                       "keptEye",
                                       "depthScaleAbove",
                                       "depthScaleBelow",
                                       "depthOffsetAbove",
                                       "depthOffsetBelow",
                                       "foldedShareAbove",
                                       "foldedShareBelow",
                                       "caustic",
                                       "verticesBelow",
                                       "pickedEnds",
                                       "wiped",
                                       "frozen"};

/// Whether it is something that is so (a switch is on, the match is above 0.9), which counts when it is so already as a
/// step opens; else it is something that happens (a thing was moved, picked), which counts only while the step is open.
bool isState(StepEvent event);

struct StepCondition {
  StepEvent when = StepEvent::movedEye;
  double value = 0;
  std::string what;
  bool operator==(const StepCondition&) const = default;
};

/// A move that "do it" makes, or that makes a level what a step begins with. What is absent stays as it is.
struct StepMove {
  std::optional<Point> eye, original, mirror;  ///< where it goes
  std::optional<double> depthScale, depthOffset;
  std::optional<int> controlPoint;  ///< of the mirror, which `controlBy` moves
  std::optional<Vector> controlBy;
  std::optional<double> tolerancePixels;  ///< 0: off
  std::optional<double> fovDegrees;
  std::optional<double> morph;               ///< 0: the original
  std::optional<Point> viewEye, viewTarget;  ///< of the 3D view
  std::optional<double> wipe;                ///< where the line of the preview's tab goes
  std::optional<int> vertex;                 ///< of the original, to be picked
  std::optional<std::array<int, 2>> ends;    ///< two of them, one after the other
  std::optional<std::array<int, 2>> pixel;   ///< of the pixel grid, to be picked
  std::string preview;                       ///< a tab, as for `viewed`
  std::string rays;                          ///< as for `raysOf`
  std::vector<std::string> putRight;         ///< as for the event
  std::string shape;                         ///< of the original: "box", "sphere", "torusKnot", ...
  std::optional<int> segments;               ///< of the original along every edge, where it is a box
  std::string mirrorKind;                    ///< as for `changedMirror`
  bool lookThrough = false;
  bool animate = false;  ///< the rays
  bool wireframe = false;
  bool caustic = false;  ///< shows it
  bool undo = false;
  bool freeze = false;  ///< the sculpture, before anything but the depth scale has moved
  bool operator==(const StepMove&) const = default;
};

/// How a step shows what it means.
struct StepShow {
  std::string tab;     ///< of the properties, see stepTabs; empty: none
  std::string widget;  ///< the English name of a control there, or of a button in the view or the preview
  std::optional<StepMove> play;
  bool operator==(const StepShow&) const = default;
};
inline constexpr std::array stepTabs{"eye", "original", "mirror", "sculpture", "lights", "rays", "view"};
/// Of the preview, in its order.
inline constexpr std::array previewTabs{"reflection", "original", "difference", "wipe"};
inline constexpr std::array stepFigures{"perspective", "construction", "columns", "edges", "occlusion"};

/// What a step asks before it says what to do.
struct StepAnswer {
  std::string text, reply;  ///< the reply says why it is right or wrong
  bool right = false;
  bool operator==(const StepAnswer&) const = default;
};
struct StepQuestion {
  std::string text;
  std::vector<StepAnswer> answers;  ///< one of them is right
  bool operator==(const StepQuestion&) const = default;
};

struct LessonStep {
  std::string id;  ///< unique in the lesson; progress is kept under it
  std::string title, why, task, notice;
  std::string figure;  ///< one of stepFigures; empty: none
  bool optional = false;
  std::vector<StepCondition> done;  ///< all of them, in any order; none: the step is only read
  StepShow show;
  std::optional<StepQuestion> question;
  StepMove
      start;  ///< what the level in its file becomes before the step; it has no morph, wipe, shape and undo
  bool operator==(const LessonStep&) const = default;
};

/// What a student gets for all steps that are not optional.
struct Badge {
  std::string title, text;
  bool operator==(const Badge&) const = default;
};

struct Lesson {
  std::string id;  ///< progress is kept under it
  Badge badge;
  std::vector<LessonStep> steps;
  bool operator==(const Lesson&) const = default;
};

/// A level's lesson; JSON pointers begin with "/lesson". What is wrong with it goes to the remarks.
Lesson readLesson(const JsonValue& json, FileRemarks& remarks);

/// The same from the text that a level keeps, which has been read before; without steps for "". Throws Error.
Lesson parseLesson(std::string_view json, const std::string& fileName);

/// The JSON Schema of a lesson.
JsonValue jsonSchema(const Lesson& lesson);

}  // namespace anamorph
