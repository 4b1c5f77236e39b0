#include "level/lesson.h"

#include <algorithm>
#include <set>
#include <type_traits>

#include <fmt/format.h>

#include "base/error.h"
#include "level/field_reader.h"
#include "level/field_schema.h"
#include "level/level.h"
#include "level/limits.h"
#include "optics/shape_table.h"

namespace anamorph {
namespace {

using Names = std::vector<std::string>;

// Which names an event or a move takes.
const Names raySources{"pixels", "vertices"};
const Names mistakeNames{"direction", "distance", "normal"};

Names namesOf(const auto& list) {
  return {list.begin(), list.end()};
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

void optional(auto& at, const char* key, auto& value, Range range) {
  if (!at.has(key)) return;
  value.emplace();
  at.field(key, *value, range);
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
  if (takesValue(condition.when)) {
    at.need({"value"});
    at.field("value", condition.value, limits::fractions);
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
  at.oneOf("preview", move.preview, namesOf(previewTabs));
  at.oneOf("rays", move.rays, raySources);
  at.oneOf("putRight", move.putRight, mistakeNames);
  at.oneOf("shape", move.shape, Names(originalShapes.begin(), originalShapes.end() - 1));  // all but files
  optional(at, "segments", move.segments, limits::boxSegments.level);
  at.oneOf("mirrorKind", move.mirrorKind, namesOf(shapeNames()));
  at.field("lookThrough", move.lookThrough);
  at.field("animate", move.animate);
  at.field("wireframe", move.wireframe);
  at.field("undo", move.undo);
  at.field("freeze", move.freeze);
}

template <typename At>
static void fields(At& at, StepShow& show) {
  at.oneOf("tab", show.tab, namesOf(stepTabs));
  at.field("widget", show.widget);
  if (at.has("play")) at.object("play", show.play.emplace());
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
  at.oneOf("figure", step.figure, namesOf(stepFigures));
  at.field("optional", step.optional);
  at.list("done", step.done, limits::mostConditions);
  at.object("show", step.show);
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
