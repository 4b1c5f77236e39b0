#include "edit/lesson_run.h"

#include <algorithm>
#include <cmath>

#include "edit/workspace.h"
#include "level/lesson.h"

namespace anamorph {
namespace {

constexpr double turnedDegrees = 10;
constexpr int requiredPoints = 10, optionalPoints = 5;

LessonFacts factsOf(const Workspace& work) {
  return {work.session.level(), work.pose, work.point, work.cell, work.session.undoCount(), work.exported};
}

bool hasTurned(const ViewPose& from, const ViewPose& to) {
  const Vector a = from.target - from.eye, b = to.target - to.eye;
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 && glm::dot(a, b) < std::cos(radians(turnedDegrees)) * lengths;
}

bool previewIs(const Workspace& work, const std::string& tab) {
  return tab == previewTabs[static_cast<std::size_t>(work.preview.tab)];
}

bool showsRaysOf(const Workspace& work, const std::string& source) {
  if (!work.rays.show) return false;
  return (work.rays.source == RaySource::pixels) == (source == "pixels");
}

bool isRight(const Mistakes& mistakes, const std::string& which) {
  if (which == "direction") return !mistakes.direction;
  return which == "distance" ? !mistakes.distance : !mistakes.normal;
}

// A figure of the settled match against a limit; nothing while it is not known.
template <typename Test>
std::optional<bool> judged(const Workspace& work, const Test& test) {
  const Products& products = work.studio.products();
  if (work.session.changing() || !products.refined) return std::nullopt;
  if (products.problem) return test(MatchReport{});
  if (!products.match) return std::nullopt;
  return test(products.match->report);
}

void beginStep(Workspace& work) {
  LessonRun& run = work.lesson;
  run.begin = factsOf(work);
  const std::size_t count = run.empty() ? 0 : run.open().done.size();
  run.wasFalse.assign(count, false);
  run.seen.assign(count, false);
  run.doneNow = false;
  run.done = !run.empty() && isDone(run.lesson, run.open(), work.progress);
}

// The first step that has not been done yet; the first of all when all have.
std::size_t whereToGoOn(const Lesson& lesson, const LessonProgress& progress) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (!isDone(lesson, lesson.steps[i], progress)) return i;
  }
  return 0;
}

void takeUpLesson(Workspace& work) {
  LessonRun& run = work.lesson;
  run = {};
  run.generation = work.session.generation();
  run.text = work.session.level().lesson;
  run.lesson = parseLesson(work.session.level().lesson, work.session.path().string());
  run.step = whereToGoOn(run.lesson, work.progress);
  beginStep(work);
}

void markDone(Workspace& work) {
  LessonRun& run = work.lesson;
  run.done = run.doneNow = true;
  work.progress[run.lesson.id].insert(run.open().id);
}

}  // namespace

std::optional<bool> holds(const StepCondition& condition, const LessonFacts& begin, const Workspace& work) {
  const Level& level = work.session.level();
  const bool rests = !work.session.changing();
  switch (condition.when) {
    case StepEvent::movedEye:
      return rests && !(level.camera.eye == begin.level.camera.eye);
    case StepEvent::movedOriginal:
      return rests && !(level.original.placement == begin.level.original.placement);
    case StepEvent::movedMirror:
      return rests && !(level.optic.shape == begin.level.optic.shape);
    case StepEvent::changedOriginal:
      return rests && !(level.original.shape == begin.level.original.shape);
    case StepEvent::changedMirror:
      return rests && condition.what == shapeName(level.optic.shape);
    case StepEvent::depthScaleChanged:
      return rests && level.sculpture.depthScale != begin.level.sculpture.depthScale;
    case StepEvent::toleranceOff:
      return level.sculpture.tolerancePixels == 0;
    case StepEvent::toleranceOn:
      return level.sculpture.tolerancePixels > 0;
    case StepEvent::pickedPixel:
      return work.cell && !(work.cell == begin.cell);
    case StepEvent::pickedVertex:
      return work.point && !(work.point == begin.point);
    case StepEvent::viewed:
      return previewIs(work, condition.what);
    case StepEvent::lookedThrough:
      return work.lookingThrough && !work.flight;
    case StepEvent::rotatedView:
      return !work.flight && !work.lookingThrough && hasTurned(begin.pose, work.pose);
    case StepEvent::morphed:
      return work.display.morph < 0.5;
    case StepEvent::raysOf:
      return showsRaysOf(work, condition.what);
    case StepEvent::animatedRays:
      return work.rays.show && work.rays.animate;
    case StepEvent::wireframe:
      return work.display.wireframe;
    case StepEvent::matchAbove:
      return judged(work, [&](const MatchReport& r) { return r.silhouetteIou > condition.value; });
    case StepEvent::matchBelow:
      return judged(work, [&](const MatchReport& r) { return r.silhouetteIou < condition.value; });
    case StepEvent::hiddenShareAbove:
      return judged(work, [&](const MatchReport& r) { return r.hiddenShare > condition.value; });
    case StepEvent::hiddenShareBelow:
      // Where nothing is seen, nothing is hidden either: that is not what is asked for.
      return judged(work, [&](const MatchReport& r) {
        return r.comparedPixels > 0 && r.hiddenShare <= condition.value;
      });
    case StepEvent::putRight:
      return rests && isRight(level.sculpture.mistakes, condition.what);
    case StepEvent::undone:
      return work.session.undoCount() != begin.undone;
    case StepEvent::exported:
      return work.exported != begin.exported;
  }
  return false;
}

bool advanceLesson(Workspace& work) {
  LessonRun& run = work.lesson;
  if (run.generation != work.session.generation() || run.text != work.session.level().lesson) {
    takeUpLesson(work);
    return true;
  }
  if (run.empty() || run.doneNow || run.open().done.empty()) return false;
  const auto& conditions = run.open().done;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const std::optional<bool> now = holds(conditions[i], run.begin, work);
    if (!now) continue;
    if (*now && run.wasFalse[i]) run.seen[i] = true;
    if (!*now) run.wasFalse[i] = true;
  }
  if (!std::all_of(run.seen.begin(), run.seen.end(), [](bool seen) { return seen; })) return false;
  markDone(work);
  return true;
}

void openStep(Workspace& work, std::size_t step) {
  LessonRun& run = work.lesson;
  if (run.empty()) return;
  finishPlay(work);
  run.step = std::min(step, run.lesson.steps.size() - 1);
  beginStep(work);
}

void nextStep(Workspace& work) {
  LessonRun& run = work.lesson;
  if (run.empty()) return;
  if (run.open().done.empty()) markDone(work);
  if (run.step + 1 < run.lesson.steps.size()) openStep(work, run.step + 1);
}

void previousStep(Workspace& work) {
  if (work.lesson.step > 0) openStep(work, work.lesson.step - 1);
}

LessonScore scoreOf(const Lesson& lesson, const LessonProgress& progress) {
  LessonScore score;
  score.steps = lesson.steps.size();
  score.badge = !lesson.steps.empty() && !lesson.badge.title.empty();
  for (const LessonStep& step : lesson.steps) {
    const int points = step.optional ? optionalPoints : requiredPoints;
    score.of += points;
    if (isDone(lesson, step, progress)) {
      ++score.done;
      score.points += points;
    } else if (!step.optional) {
      score.badge = false;
    }
  }
  return score;
}

bool isDone(const Lesson& lesson, const LessonStep& step, const LessonProgress& progress) {
  const auto found = progress.find(lesson.id);
  return found != progress.end() && found->second.count(step.id) > 0;
}

}  // namespace anamorph
