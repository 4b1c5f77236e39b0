#include "edit/lesson_run.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/language.h"
#include "edit/lesson_start.h"
#include "level/level_condition.h"

namespace anamorph {
namespace {

constexpr double turnedDegrees = 20;
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

// Degrees below the horizon.
double lookingDown(const ViewPose& pose) {
  const Vector ahead = pose.target - pose.eye;
  return degrees(std::atan2(-ahead.z, std::hypot(ahead.x, ahead.y)));
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

// What of the match a condition asks; nothing when it asks nothing of it.
using MatchTest = std::function<bool(const MatchReport&)>;

MatchTest matchTest(const StepCondition& condition) {
  const double value = condition.value;
  switch (condition.when) {
    case StepEvent::matchAbove:
      return [=](const MatchReport& report) { return report.silhouetteIou > value; };
    case StepEvent::matchBelow:
      return [=](const MatchReport& report) { return report.silhouetteIou < value; };
    case StepEvent::hiddenShareAbove:
      return [=](const MatchReport& report) { return report.hiddenShare > value; };
    case StepEvent::hiddenShareBelow:
      // Where nothing is seen, nothing is hidden either: that is not what is asked for.
      return
          [=](const MatchReport& report) { return report.comparedPixels > 0 && report.hiddenShare <= value; };
    case StepEvent::foldedShareAbove:
      return [=](const MatchReport& report) { return report.foldedShare > value; };
    case StepEvent::foldedShareBelow:
      return
          [=](const MatchReport& report) { return report.comparedPixels > 0 && report.foldedShare <= value; };
    default:
      return {};
  }
}

// Nothing while the settled match is not known.
std::optional<bool> judged(const Editor& editor, const MatchTest& test) {
  const LevelResult& result = editor.updater.result();
  if (editor.session.changing() || !result.refined) return std::nullopt;
  if (result.problem) return test(MatchReport{});
  if (!result.match) return std::nullopt;
  return test(result.match->report);
}

// A number that is on its way is nowhere yet: that is how one that a step begins with is seen otherwise. Of the rest
// nothing is known.
std::optional<bool> whileDragged(StepEvent event) {
  switch (event) {
    case StepEvent::eyeAbove:
    case StepEvent::eyeAway:
    case StepEvent::depthScaleAbove:
    case StepEvent::depthScaleBelow:
    case StepEvent::depthOffsetAbove:
    case StepEvent::depthOffsetBelow:
      return false;
    default:
      return std::nullopt;
  }
}

// What is picked, shown and done in the window.
bool holdsInView(const StepCondition& condition, const LessonFacts& begin, const Editor& editor) {
  const bool turnedFreely = !editor.flight && !editor.lookingThrough;
  switch (condition.when) {
    case StepEvent::pickedPixel:
      return editor.cell && !(editor.cell == begin.cell);
    case StepEvent::pickedVertex:
      return editor.point && !(editor.point == begin.point);
    case StepEvent::pickedEnds:
      return areEndsPicked(editor);
    case StepEvent::viewed:
      return previewIs(editor, condition.what);
    case StepEvent::wiped:
      return previewIs(editor, "wipe") && std::abs(editor.preview.wipe - begin.wipe) > wipedShare;
    case StepEvent::lookedThrough:
      return editor.lookingThrough && !editor.flight;
    case StepEvent::rotatedView:
      return turnedFreely && hasTurned(begin.pose, editor.pose);
    case StepEvent::lookedDown:
      return turnedFreely && lookingDown(editor.pose) > condition.value;
    case StepEvent::morphed:
      return editor.display.morph < 0.5;
    case StepEvent::raysOf:
      return showsRaysOf(editor, condition.what);
    case StepEvent::animatedRays:
      return editor.rays.show && editor.rays.animate;
    case StepEvent::wireframe:
      return editor.display.wireframe;
    case StepEvent::caustic:
      return editor.display.caustic;
    case StepEvent::verticesBelow:
      return !editor.session.changing() && hasFewerVertices(editor, condition.value);
    case StepEvent::undone:
      return editor.session.undoCount() != begin.undone;
    case StepEvent::exported:
      return editor.exported != begin.exported;
    default:
      return false;
  }
}

// Whether something is to be clicked in the 3D view, where through the RT camera a click takes a pixel.
bool needsPicking(const LessonStep& step) {
  const auto& play = step.show.play;
  return play && (play->vertex || play->ends || play->controlPoint);
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
  if (const MatchTest test = matchTest(condition)) return judged(editor, test);
  if (const auto held = holdsOfLevel(condition, begin.level, editor.session.level()))
    return editor.session.changing() ? whileDragged(condition.when) : held;
  return holdsInView(condition, begin, editor);
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
  if (editor.lookingThrough && needsPicking(run.open())) toggleLookThrough(editor);
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
