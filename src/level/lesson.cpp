#include "level/lesson.h"

#include <algorithm>
#include <set>
#include <type_traits>

#include <fmt/format.h>

#include "base/error.h"
#include "level/field_reader.h"
#include "level/level_fields.h"
#include "level/limits.h"

namespace anamorph {
namespace {

using Names = std::vector<std::string>;

// Which names an event or a move takes.
const Names raySources{"pixels", "vertices"};
const Names mistakeNames{"direction", "distance", "normal"};

Names namesOf(const auto& list) {
  return {list.begin(), list.end()};
}

std::string oneOf(const Names& names) {
  std::string text = "one of";
  for (const std::string& name : names) text += (name == names.front() ? " " : ", ") + quoteJson(name);
  return text;
}

void name(FieldReader& at, const char* key, std::string& value, const Names& names) {
  at.field(key, value);
  const bool known = std::find(names.begin(), names.end(), value) != names.end();
  at.expect(known || (value.empty() && !at.has(key)), key, oneOf(names));
}

// Empty: the event takes no name.
Names namesFor(StepEvent event) {
  switch (event) {
    case StepEvent::changedMirror:
      return namesOf(shapeNames());
    case StepEvent::viewed:
      return namesOf(previewTabs);
    case StepEvent::raysOf:
      return raySources;
    case StepEvent::putRight:
      return mistakeNames;
    default:
      return {};
  }
}

bool takesValue(StepEvent event) {
  return event == StepEvent::matchAbove || event == StepEvent::matchBelow ||
         event == StepEvent::hiddenShareAbove || event == StepEvent::hiddenShareBelow;
}

void optional(FieldReader& at, const char* key, auto& value, Range range) {
  if (!at.has(key)) return;
  value.emplace();
  at.field(key, *value, range);
}

void checkIds(const Lesson& lesson, const std::string& fileName) {
  std::set<std::string> seen;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (seen.insert(lesson.steps[i].id).second) continue;
    throw Error("expected an id of its own, got " + quoteJson(lesson.steps[i].id) + " again", fileName,
                fmt::format("/lesson/steps/{}/id", i));
  }
}

}  // namespace

// Not in the nameless namespace, where FieldReader would not find them by their arguments' types.

static void fields(FieldReader& at, StepCondition& condition) {
  at.choice("when", condition.when, stepEvents);
  if (takesValue(condition.when)) {
    at.need({"value"});
    at.field("value", condition.value, limits::fractions);
  }
  const Names names = namesFor(condition.when);
  if (names.empty()) return;
  at.need({"what"});
  name(at, "what", condition.what, names);
}

static void fields(FieldReader& at, StepMove& move) {
  optional(at, "eye", move.eye, limits::coordinates);
  optional(at, "original", move.original, limits::coordinates);
  optional(at, "mirror", move.mirror, limits::coordinates);
  optional(at, "depthScale", move.depthScale, limits::depthScale.level);
  if (at.has("tolerance"))
    at.numberOrOff("tolerance", move.tolerancePixels.emplace(), limits::tolerance.level);
  optional(at, "fovDegrees", move.fovDegrees, limits::fieldOfView.level);
  optional(at, "morph", move.morph, limits::fractions);
  optional(at, "viewEye", move.viewEye, limits::coordinates);
  optional(at, "viewTarget", move.viewTarget, limits::coordinates);
  optional(at, "vertex", move.vertex, limits::vertexNumber);
  if (at.has("pixel")) {
    auto& [column, row] = move.pixel.emplace();
    at.pair("pixel", column, row, limits::cellNumber);
  }
  name(at, "preview", move.preview, namesOf(previewTabs));
  name(at, "rays", move.rays, raySources);
  name(at, "putRight", move.putRight, mistakeNames);
  name(at, "shape", move.shape, Names(originalShapes.begin(), originalShapes.end() - 1));  // all but files
  optional(at, "segments", move.segments, limits::boxSegments.level);
  name(at, "mirrorKind", move.mirrorKind, namesOf(shapeNames()));
  at.field("lookThrough", move.lookThrough);
  at.field("animate", move.animate);
  at.field("wireframe", move.wireframe);
  at.field("undo", move.undo);
  at.field("freeze", move.freeze);
}

static void fields(FieldReader& at, StepShow& show) {
  name(at, "tab", show.tab, namesOf(stepTabs));
  at.field("widget", show.widget);
  if (at.has("play")) at.object("play", show.play.emplace());
}

static void fields(FieldReader& at, LessonStep& step) {
  at.need({"id", "title", "why", "do"});
  at.field("id", step.id);
  at.expect(!step.id.empty(), "id", "a name that is not empty");
  at.field("title", step.title);
  at.field("why", step.why);
  at.field("do", step.task);
  at.field("notice", step.notice);
  name(at, "figure", step.figure, namesOf(stepFigures));
  at.field("optional", step.optional);
  at.list("done", step.done, limits::mostConditions);
  at.object("show", step.show);
}

static void fields(FieldReader& at, Badge& badge) {
  at.need({"title", "text"});
  at.field("title", badge.title);
  at.field("text", badge.text);
}

static void fields(FieldReader& at, Lesson& lesson) {
  at.need({"id", "steps"});
  at.field("id", lesson.id);
  at.expect(!lesson.id.empty(), "id", "a name that is not empty");
  at.object("badge", lesson.badge);
  at.list("steps", lesson.steps, limits::mostSteps);
}

Lesson parseLesson(std::string_view json, const std::string& fileName) {
  Lesson lesson;
  if (json.empty()) return lesson;
  const JsonValue document = parseJson(json, fileName);
  FieldReader::Context context{fileName, {}};
  FieldReader reader(document, "/lesson", context);
  fields(reader, lesson);
  reader.finish();
  // A misspelt key of a step would silently be no condition: here, unknown ones are errors.
  if (!context.unknownKeys.empty()) {
    const UnknownKey& unknown = context.unknownKeys.front();
    throw Error("expected a key of a lesson, got " + quoteJson(unknown.key), fileName,
                joinJsonPath(unknown.object, unknown.key));
  }
  checkIds(lesson, fileName);
  return lesson;
}

}  // namespace anamorph
