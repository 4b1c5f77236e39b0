#include "level/lesson.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "base/error.h"
#include "level/field_reader.h"
#include "level/field_schema.h"
#include "level/level.h"
#include "level/limits.h"
#include "level/mirror_kind.h"

namespace anamorph {
namespace {

using Names = std::vector<std::string>;

// Which names an event or a move takes.
const Names raySources{"pixels", "vertices"};
const Names mistakeNames{"direction", "distance", "normal"};

Names namesIn(const auto& list) {
  return {list.begin(), list.end()};
}

// Empty: the event takes no name.
Names namesFor(StepEvent event) {
  switch (event) {
    case StepEvent::changedMirror:
      return mirrorKinds();
    case StepEvent::viewed:
      return namesIn(previewTabs);
    case StepEvent::raysOf:
      return raySources;
    case StepEvent::putRight:
      return mistakeNames;
    default:
      return {};
  }
}

// Nothing: the event takes no value.
std::optional<Range> valuesFor(StepEvent event) {
  switch (event) {
    case StepEvent::matchAbove:
    case StepEvent::matchBelow:
    case StepEvent::hiddenShareAbove:
    case StepEvent::hiddenShareBelow:
    case StepEvent::foldedShareAbove:
    case StepEvent::foldedShareBelow:
      return limits::fractions;
    case StepEvent::depthOffsetAbove:
    case StepEvent::depthOffsetBelow:
      return limits::depthOffset.level;
    case StepEvent::lookedDown:
      return limits::lookingDown;
    case StepEvent::eyeAbove:
      return limits::coordinates;
    case StepEvent::eyeAway:
      return limits::lengths;
    case StepEvent::depthScaleAbove:
    case StepEvent::depthScaleBelow:
      return limits::depthScale.level;
    case StepEvent::verticesBelow:
      return limits::vertexNumber;
    default:
      return std::nullopt;
  }
}

void optional(auto& at, const char* key, auto& value, Range range) {
  if (!at.has(key)) return;
  value.emplace();
  at.field(key, *value, range);
}

// What is made there and back, what another box would change, and what goes by the history begin nothing.
bool canBegin(const StepMove& start) {
  return !start.morph && !start.wipe && start.shape.empty() && !start.undo;
}

void checkIds(const Lesson& lesson, const JsonValue& json, FileRemarks& remarks) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const std::string path = fmt::format("/steps/{}/id", i);
    const JsonValue* id = findByPath(json, path);
    if (!id || lesson.steps[i].id.empty() || seen.insert(lesson.steps[i].id).second) continue;
    remarks.addFault("expected an id of its own, got " + quoteJson(lesson.steps[i].id) + " again", id->place,
                     "/lesson" + path);
  }
}

}  // namespace

// Not in the nameless namespace, where FieldReader and FieldSchema would not find them by their arguments' types.

template <typename At>
static void fields(At& at, StepCondition& condition) {
  at.choice("when", condition.when, stepEvents);
  if (const auto values = valuesFor(condition.when)) {
    at.need({"value"});
    at.field("value", condition.value, *values);
  }
  const Names names = namesFor(condition.when);
  if (names.empty()) return;
  at.need({"what"});
  at.oneOf("what", condition.what, names);
}

template <typename At>
static void fields(At& at, StepMove& move) {
  optional(at, "eye", move.eye, limits::coordinates);
  optional(at, "original", move.original, limits::coordinates);
  optional(at, "mirror", move.mirror, limits::coordinates);
  optional(at, "depthScale", move.depthScale, limits::depthScale.level);
  optional(at, "depthOffset", move.depthOffset, limits::depthOffset.level);
  optional(at, "controlPoint", move.controlPoint, limits::controlPointNumber);
  optional(at, "controlBy", move.controlBy, limits::coordinates);
  at.expect(move.controlPoint.has_value() == move.controlBy.has_value(), "controlBy",
            "controlPoint and controlBy together");
  if (at.has("tolerance"))
    at.numberOrOff("tolerance", move.tolerancePixels.emplace(), limits::tolerance.level);
  optional(at, "fovDegrees", move.fovDegrees, limits::fieldOfView.level);
  optional(at, "morph", move.morph, limits::fractions);
  optional(at, "viewEye", move.viewEye, limits::coordinates);
  optional(at, "viewTarget", move.viewTarget, limits::coordinates);
  optional(at, "wipe", move.wipe, limits::fractions);
  optional(at, "vertex", move.vertex, limits::vertexNumber);
  if (at.has("ends")) {
    auto& [first, second] = move.ends.emplace();
    at.pair("ends", first, second, limits::vertexNumber);
  }
  if (at.has("pixel")) {
    auto& [column, row] = move.pixel.emplace();
    at.pair("pixel", column, row, limits::cellNumber);
  }
  at.oneOf("preview", move.preview, namesIn(previewTabs));
  at.oneOf("rays", move.rays, raySources);
  at.names("putRight", move.putRight, mistakeNames);
  at.oneOf("shape", move.shape, Names(originalShapes.begin(), originalShapes.end() - 1));  // all but files
  optional(at, "segments", move.segments, limits::boxSegments.level);
  at.oneOf("mirrorKind", move.mirrorKind, mirrorKinds());
  at.field("lookThrough", move.lookThrough);
  at.field("animate", move.animate);
  at.field("wireframe", move.wireframe);
  at.field("caustic", move.caustic);
  at.field("undo", move.undo);
  at.field("freeze", move.freeze);
}

template <typename At>
static void fields(At& at, StepShow& show) {
  at.oneOf("tab", show.tab, namesIn(stepTabs));
  at.field("widget", show.widget);
  if (at.has("play")) at.object("play", show.play.emplace());
}

template <typename At>
static void fields(At& at, StepAnswer& answer) {
  at.need({"text", "reply"});
  at.field("text", answer.text);
  at.field("reply", answer.reply);
  at.field("right", answer.right);
}

template <typename At>
static void fields(At& at, StepQuestion& question) {
  at.need({"text", "answers"});
  at.field("text", question.text);
  at.list("answers", question.answers, limits::mostAnswers);
  const auto right = std::count_if(question.answers.begin(), question.answers.end(),
                                   [](const StepAnswer& answer) { return answer.right; });
  at.expect(right == 1, "answers", "answers of which one is right");
}

template <typename At>
static void fields(At& at, LessonStep& step) {
  at.need({"id", "title", "why", "do"});
  at.field("id", step.id);
  at.expect(!step.id.empty(), "id", "a name that is not empty");
  at.field("title", step.title);
  at.field("why", step.why);
  at.field("do", step.task);
  at.field("notice", step.notice);
  at.oneOf("figure", step.figure, namesIn(stepFigures));
  at.field("optional", step.optional);
  at.list("done", step.done, limits::mostConditions);
  at.object("show", step.show);
  if (at.has("ask")) at.object("ask", step.question.emplace());
  at.object("start", step.start);
  at.expect(canBegin(step.start), "start", "a move without morph, wipe, shape and undo");
}

template <typename At>
static void fields(At& at, Badge& badge) {
  at.need({"title", "text"});
  at.field("title", badge.title);
  at.field("text", badge.text);
}

template <typename At>
static void fields(At& at, Lesson& lesson) {
  at.need({"id", "steps"});
  at.field("id", lesson.id);
  at.expect(!lesson.id.empty(), "id", "a name that is not empty");
  at.object("badge", lesson.badge);
  at.list("steps", lesson.steps, limits::mostSteps);
}

bool isState(StepEvent event) {
  switch (event) {
    case StepEvent::changedMirror:
    case StepEvent::toleranceOff:
    case StepEvent::toleranceOn:
    case StepEvent::viewed:
    case StepEvent::raysOf:
    case StepEvent::wireframe:
    case StepEvent::matchAbove:
    case StepEvent::matchBelow:
    case StepEvent::hiddenShareAbove:
    case StepEvent::hiddenShareBelow:
    case StepEvent::putRight:
    case StepEvent::lookedDown:
    case StepEvent::eyeAbove:
    case StepEvent::eyeAway:
    case StepEvent::keptEye:
    case StepEvent::depthScaleAbove:
    case StepEvent::depthScaleBelow:
    case StepEvent::depthOffsetAbove:
    case StepEvent::depthOffsetBelow:
    case StepEvent::foldedShareAbove:
    case StepEvent::foldedShareBelow:
    case StepEvent::caustic:
    case StepEvent::verticesBelow:
    case StepEvent::frozen:
      return true;
    default:
      return false;
  }
}

Lesson readLesson(const JsonValue& json, FileRemarks& remarks) {
  Lesson lesson;
  // A misspelt key of a step would silently be no condition: unknown ones are refused.
  FieldReader::Context context(remarks.file(), FieldReader::UnknownKeys::refused);
  FieldReader reader(json, "/lesson", context);
  fields(reader, lesson);
  reader.finish();
  checkIds(lesson, json, context.remarks);
  remarks.add(context.remarks);
  return lesson;
}

Lesson parseLesson(std::string_view json, const std::string& fileName) {
  if (json.empty()) return {};
  FileRemarks remarks(fileName);
  Lesson lesson = readLesson(parseJson(json, fileName), remarks);
  remarks.throwFaults();
  return lesson;
}

JsonValue jsonSchema(const Lesson& lesson) {
  return schemaOf(lesson);
}

}  // namespace anamorph
