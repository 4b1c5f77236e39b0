#include "edit/lesson_run.h"

#include <algorithm>
#include <cmath>

#include "base/language.h"
#include "edit/lesson_start.h"

namespace anamorph {
namespace {

constexpr double turnedDegrees = 10;
constexpr double wipedShare = 0.1;  // of the picture's width

LessonFacts factsOf(const Editor& editor) {
  return {editor.session.level(), editor.flight ? editor.flight->goal : editor.pose,
          editor.point,           editor.cell,
          editor.preview.wipe,    editor.session.undoCount(),
          editor.exported};
}

bool hasTurned(const ViewPose& from, const ViewPose& to) {
  const Vector a = from.target - from.eye, b = to.target - to.eye;
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0 && glm::dot(a, b) < std::cos(radians(turnedDegrees)) * lengths;
}

bool previewIs(const Editor& editor, const std::string& tab) {
  return tab == previewTabs[static_cast<std::size_t>(editor.preview.tab)];
}

bool showsRaysOf(const Editor& editor, const std::string& source) {
  if (!editor.rays.show) return false;
  return (editor.rays.source == RaySource::pixels) == (source == "pixels");
}

// Two ends of the original, for all that a mouse can tell.
bool areEndsPicked(const Editor& editor) {
  const auto& mesh = editor.updater.result().original.mesh;
  if (!mesh || !editor.point || !editor.earlierPoint) return false;
  if (!isOn(*mesh, *editor.point) || !isOn(*mesh, *editor.earlierPoint)) return false;
  const Vector size = originalBox(editor).size();
  return glm::length(pointOn(*mesh, *editor.point) - pointOn(*mesh, *editor.earlierPoint)) >
         0.5 * std::max({size.x, size.y, size.z});
}

bool hasFewerVertices(const Editor& editor, double count) {
  const auto& mesh = editor.updater.result().original.mesh;
  return mesh && static_cast<double>(mesh->positions.size()) < count;
}

bool isRight(Mistakes mistakes, const std::string& which) {
  return !mistakeOf(mistakes, which);
}

// A figure of the settled match against a limit; nothing while it is not known.
template <typename Test>
std::optional<bool> judged(const Editor& editor, const Test& test) {
  const LevelResult& result = editor.updater.result();
  if (editor.session.changing() || !result.refined) return std::nullopt;
  if (result.problem) return test(MatchReport{});
  if (!result.match) return std::nullopt;
  return test(result.match->report);
}

// How a step was come to: by going on from the one before it, or in its own start.
enum class Arrival { onward, afresh };

void beginStep(Editor& editor, Arrival arrival) {
  LessonRun& run = editor.lesson;
  run.begin = factsOf(editor);
  run.wasFalse.clear();
  run.seen.clear();
  run.answer.reset();
  run.doneNow = run.done = false;
  if (run.empty()) return;
  const bool brought = arrival == Arrival::onward && !isStartMissed(run, run.begin.level);
  for (const StepCondition& condition : run.open().done) {
    run.wasFalse.push_back(condition.when == StepEvent::keptEye || (brought && isState(condition.when)));
  }
  run.seen.assign(run.wasFalse.size(), false);
  run.done = isDone(run.lesson, run.open(), editor.progress);
}

// The first step that has not been done yet; the first of all when all have.
std::size_t whereToGoOn(const Lesson& lesson, const LessonProgress& progress) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (!isDone(lesson, lesson.steps[i], progress)) return i;
  }
  return 0;
}

void takeUpLesson(Editor& editor) {
  LessonRun& run = editor.lesson;
  const Session& session = editor.session;
  const bool opened = run.generation != session.generation();
  run = {};
  run.generation = session.generation();
  run.text = session.level().text->lesson;
  run.base = session.saved().text->lesson == run.text ? session.saved() : session.level();
  run.lesson = parseLesson(run.text, session.path().string());
  run.step = whereToGoOn(run.lesson, editor.progress);
  // Not into what was left changed, rescued or pasted; and a level that was just opened is looked at afresh already.
  if (opened && !session.modified() && !run.empty() && !(run.open().start == StepMove{}))
    beginAtStart(editor);
  beginStep(editor, Arrival::afresh);
}

void markDone(Editor& editor) {
  LessonRun& run = editor.lesson;
  run.done = run.doneNow = true;
  editor.progress[run.lesson.id].insert(run.open().id);
}

}  // namespace

std::optional<bool> holds(const StepCondition& condition, const LessonFacts& begin, const Editor& editor) {
  const Level& level = editor.session.level();
  const bool rests = !editor.session.changing();
  switch (condition.when) {
    case StepEvent::movedEye:
      return rests && !(level.camera.eye == begin.level.camera.eye);
    case StepEvent::movedOriginal:
      return rests && !(level.original.placement == begin.level.original.placement);
    case StepEvent::movedMirror:
      return rests && !(level.optic.shape() == begin.level.optic.shape());
    case StepEvent::changedOriginal:
      return rests && !(level.original.shape == begin.level.original.shape);
    case StepEvent::changedMirror:
      return rests && condition.what == shapeName(level.optic.shape());
    case StepEvent::depthScaleChanged:
      return rests && level.sculpture.depthScale != begin.level.sculpture.depthScale;
    case StepEvent::toleranceOff:
      return level.sculpture.tolerancePixels == 0;
    case StepEvent::toleranceOn:
      return level.sculpture.tolerancePixels > 0;
    case StepEvent::pickedPixel:
      return editor.cell && !(editor.cell == begin.cell);
    case StepEvent::pickedVertex:
      return editor.point && !(editor.point == begin.point);
    case StepEvent::viewed:
      return previewIs(editor, condition.what);
    case StepEvent::lookedThrough:
      return editor.lookingThrough && !editor.flight;
    case StepEvent::rotatedView:
      return !editor.flight && !editor.lookingThrough && hasTurned(begin.pose, editor.pose);
    case StepEvent::morphed:
      return editor.display.morph < 0.5;
    case StepEvent::raysOf:
      return showsRaysOf(editor, condition.what);
    case StepEvent::animatedRays:
      return editor.rays.show && editor.rays.animate;
    case StepEvent::wireframe:
      return editor.display.wireframe;
    case StepEvent::matchAbove:
      return judged(editor, [&](const MatchReport& r) { return r.silhouetteIou > condition.value; });
    case StepEvent::matchBelow:
      return judged(editor, [&](const MatchReport& r) { return r.silhouetteIou < condition.value; });
    case StepEvent::hiddenShareAbove:
      return judged(editor, [&](const MatchReport& r) { return r.hiddenShare > condition.value; });
    case StepEvent::hiddenShareBelow:
      // Where nothing is seen, nothing is hidden either: that is not what is asked for.
      return judged(editor, [&](const MatchReport& r) {
        return r.comparedPixels > 0 && r.hiddenShare <= condition.value;
      });
    case StepEvent::putRight:
      return rests && isRight(level.sculpture.mistakes, condition.what);
    case StepEvent::undone:
      return editor.session.undoCount() != begin.undone;
    case StepEvent::exported:
      return editor.exported != begin.exported;
    case StepEvent::frozen:
      return level.sculpture.frozen.has_value();
    case StepEvent::eyeAbove:
      return rests && level.camera.eye.z > condition.value;
    case StepEvent::eyeAway:
      return rests && glm::length(level.camera.eye - middleOf(level.optic.shape())) > condition.value;
    case StepEvent::keptEye:
      return level.camera.eye == begin.level.camera.eye;
    case StepEvent::depthScaleAbove:
      return rests && level.sculpture.depthScale > condition.value;
    case StepEvent::depthScaleBelow:
      return rests && level.sculpture.depthScale < condition.value;
    case StepEvent::depthOffsetAbove:
      return rests && level.sculpture.depthOffset > condition.value;
    case StepEvent::depthOffsetBelow:
      return rests && level.sculpture.depthOffset < condition.value;
    case StepEvent::foldedShareAbove:
      return judged(editor, [&](const MatchReport& r) { return r.foldedShare > condition.value; });
    case StepEvent::foldedShareBelow:
      return judged(editor, [&](const MatchReport& r) {
        return r.comparedPixels > 0 && r.foldedShare <= condition.value;
      });
    case StepEvent::caustic:
      return editor.display.caustic;
    case StepEvent::verticesBelow:
      return rests && hasFewerVertices(editor, condition.value);
    case StepEvent::pickedEnds:
      return areEndsPicked(editor);
    case StepEvent::wiped:
      return previewIs(editor, "wipe") && std::abs(editor.preview.wipe - begin.wipe) > wipedShare;
  }
  return false;
}

bool advanceLesson(Editor& editor) {
  LessonRun& run = editor.lesson;
  if (run.generation != editor.session.generation() || run.text != editor.session.level().text->lesson) {
    takeUpLesson(editor);
    return true;
  }
  if (run.empty() || run.doneNow || isOnlyRead(run.open())) return false;
  const auto& conditions = run.open().done;
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const std::optional<bool> now = holds(conditions[i], run.begin, editor);
    const bool counts = now.value_or(false) && run.wasFalse[i];
    run.seen[i] = counts || (run.seen[i] && !isState(conditions[i].when));
    if (now && !*now) run.wasFalse[i] = true;
  }
  if (!isAnswered(run)) return false;
  if (!std::all_of(run.seen.begin(), run.seen.end(), [](bool seen) { return seen; })) return false;
  markDone(editor);
  return true;
}

void openStep(Editor& editor, std::size_t step) {
  LessonRun& run = editor.lesson;
  if (run.empty()) return;
  finishPlay(editor);
  run.step = std::min(step, run.lesson.steps.size() - 1);
  const Level before = editor.session.level();
  restoreStart(editor);
  if (!(editor.session.level() == before))
    editor.status.sayOf(editor.session.level(), tr("As this step begins. Ctrl+Z: as it was."));
  beginStep(editor, Arrival::afresh);
}

void nextStep(Editor& editor) {
  LessonRun& run = editor.lesson;
  if (run.empty()) return;
  if (isOnlyRead(run.open())) markDone(editor);
  if (run.step + 1 == run.lesson.steps.size()) return;
  finishPlay(editor);
  restRays(editor);
  ++run.step;
  beginStep(editor, Arrival::onward);
}

void previousStep(Editor& editor) {
  if (editor.lesson.step > 0) openStep(editor, editor.lesson.step - 1);
}

void answerStep(Editor& editor, std::size_t answer) {
  LessonRun& run = editor.lesson;
  if (run.empty() || !run.open().question || answer >= run.open().question->answers.size()) return;
  run.answer = answer;
}

}  // namespace anamorph
