#include "edit/lesson_start.h"

#include <algorithm>
#include <cmath>

#include "edit/lesson_move.h"

namespace anamorph {
namespace {

constexpr double nearEnough = 0.2;  // of the larger one

bool isNear(double is, double wanted) {
  return std::abs(is - wanted) <= nearEnough * std::max(std::abs(is), std::abs(wanted));
}
bool isNear(const Point& is, const Point& wanted) {
  return glm::length(is - wanted) <= nearEnough * std::max(glm::length(is), glm::length(wanted));
}

// Nothing wanted is near to everything.
template <typename Value>
bool isNear(const Value& is, const std::optional<Value>& wanted) {
  return !wanted || isNear(is, *wanted);
}

// What is either so or not.
bool areSwitchesSet(const StepMove& start, const Level& level) {
  StepMove switches;
  switches.tolerancePixels = start.tolerancePixels;
  switches.putRight = start.putRight;
  switches.segments = start.segments;
  return begun(switches, level, {}) == level;
}

}  // namespace

Level startOf(const Editor& editor, std::size_t step) {
  const LessonRun& run = editor.lesson;
  const StepMove& start = run.lesson.steps[step].start;
  Level level = levelAt(start, begun(start, run.base, {}), 1);
  level.text = editor.session.level().text;
  return level;
}

namespace {

void lookAsAtStart(Editor& editor) {
  lookAfresh(editor);
  editor.preview.wipe = 0.5;
  editor.rays.show = true;
  editor.rays.source = RaySource::vertices;
  editor.display.wireframe = false;
  editor.display.caustic = false;
  moveView(editor, editor.lesson.open().start);
}

}  // namespace

void restoreStart(Editor& editor) {
  editor.session.edit(startOf(editor, editor.lesson.step));
  lookAsAtStart(editor);
}

void beginAtStart(Editor& editor) {
  editor.session.beginWith(startOf(editor, editor.lesson.step));
  lookAsAtStart(editor);
}

bool isStartMissed(const LessonRun& run, const Level& level) {
  const StepMove& start = run.open().start;
  return !(areSwitchesSet(start, level) && level.sculpture.frozen.has_value() == start.freeze &&
           isNear(level.camera.eye, start.eye) && isNear(level.original.placement.position, start.original) &&
           isNear(middleOf(level.optic.shape()), start.mirror) &&
           isNear(level.sculpture.depthScale, start.depthScale) &&
           isNear(level.sculpture.depthOffset, start.depthOffset) &&
           isNear(level.camera.fovDegrees, start.fovDegrees) &&
           (start.mirrorKind.empty() || start.mirrorKind == shapeName(level.optic.shape())));
}

}  // namespace anamorph
