#include "level/lesson_check.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/spelling.h"
#include "level/level_condition.h"
#include "level/move_numbers.h"
#include "level/step_controls.h"
#include "optics/shape_table.h"

namespace anamorph {
namespace {

// Adds a fault at a place of the document.
class LessonFaults {
 public:
  LessonFaults(const JsonValue& document, FileRemarks& remarks) : document_(document), remarks_(remarks) {}

  void add(const std::string& path, const std::string& expected, const std::string& hint = {}) {
    const JsonValue* value = findByPath(document_, path);
    if (!value) return;
    remarks_.addFault("expected " + expected + ", got " + describeJson(*value) + hint, value->place, path);
  }

 private:
  const JsonValue& document_;
  FileRemarks& remarks_;
};

// What the move makes of the numbers and switches of a level and of its kind of mirror; the original keeps its kind.
LevelScene played(LevelScene level, const StepMove& move) {
  setSwitches(level, move);
  setNumbers(level, move, 1);
  return level;
}

// Whether the move does in the window what the condition waits for; nothing for a condition of the level or of the match.
std::optional<bool> happens(const StepCondition& condition, const StepMove& start, const StepMove& move) {
  switch (condition.when) {
    case StepEvent::pickedPixel:
      return move.pixel.has_value();
    case StepEvent::pickedVertex:
      return move.vertex || move.ends;
    case StepEvent::pickedEnds:
      return move.ends.has_value();
    case StepEvent::viewed:
      return (move.preview.empty() ? start.preview : move.preview) == condition.what;
    case StepEvent::lookedThrough:
      return move.lookThrough;
    case StepEvent::rotatedView:
    case StepEvent::lookedDown:
      return move.viewEye || move.viewTarget;
    case StepEvent::morphed:
      return move.morph && *move.morph < 0.5;
    case StepEvent::raysOf:
      return (move.rays.empty() ? start.rays : move.rays) == condition.what;
    case StepEvent::animatedRays:
      return move.animate;
    case StepEvent::wireframe:
      return move.wireframe || start.wireframe;
    case StepEvent::caustic:
      return move.caustic || start.caustic;
    case StepEvent::wiped:
      return move.wipe.has_value();
    case StepEvent::undone:
      return move.undo;
    case StepEvent::exported:
      return false;
    default:
      return std::nullopt;
  }
}

// Whether the condition can be true after the move; figures of the match are not computed for it. `before`: as the step
// begins, by its `start`.
bool canHold(const StepCondition& condition, const StepMove& start, const StepMove& move,
             const LevelScene& before) {
  if (const auto done = happens(condition, start, move)) return *done;
  const bool held = holdsOfLevel(condition, before, played(before, move)).value_or(true);
  switch (condition.when) {
    case StepEvent::movedOriginal:
    case StepEvent::changedOriginal:
      return held || !move.shape.empty();
    case StepEvent::movedMirror:
      return held || move.mirror || move.controlBy;
    case StepEvent::frozen:
      return move.freeze || start.freeze || before.sculpture.frozen;
    default:
      return held;
  }
}

// That what the move picks is there: of a level that it has been made in.
void checkPicks(const StepMove& move, const std::string& path, const LevelScene& level, std::size_t vertices,
                LessonFaults& faults) {
  const std::size_t controls = controlPointsOf(level.optic.shape()).size();
  if (move.controlPoint && static_cast<std::size_t>(*move.controlPoint) >= controls) {
    faults.add(path + "/controlPoint",
               controls == 0 ? "no control point: the mirror has none"
                             : fmt::format("one of the mirror's control points, 0 to {}", controls - 1));
  }
  const PixelGrid& grid = level.grid;
  if (vertices == 0) return;  // that is said already
  const auto checkVertex = [&](int vertex, const std::string& at) {
    if (static_cast<std::size_t>(vertex) < vertices) return;
    faults.add(path + at, fmt::format("one of the original's vertices, 0 to {}", vertices - 1));
  };
  if (move.vertex) checkVertex(*move.vertex, "/vertex");
  for (std::size_t i = 0; move.ends && i < 2; ++i) checkVertex((*move.ends)[i], fmt::format("/ends/{}", i));
  if (move.pixel && ((*move.pixel)[0] >= grid.columns || (*move.pixel)[1] >= grid.rows)) {
    faults.add(path + "/pixel", fmt::format("a pixel of the grid of {} x {}", grid.columns, grid.rows));
  }
}

void checkPlay(const LessonStep& step, const std::string& path, const LevelScene& before,
               std::size_t vertices, LessonFaults& faults) {
  const StepMove& move = *step.show.play;
  checkPicks(move, path, played(before, move), vertices, faults);
  for (const StepCondition& condition : step.done) {
    if (canHold(condition, step.start, move, before)) continue;
    const std::string event = stepEvents[static_cast<std::size_t>(condition.when)];
    const std::string what = condition.what.empty() ? "" : " \"" + condition.what + '"';
    faults.add(path, fmt::format("a move after which its step is done (\"{}\"{})", event, what));
  }
}

}  // namespace

void checkLesson(const LoadedLevel& loaded, std::size_t vertices, FileRemarks& remarks) {
  const std::vector<std::string>& controls = stepControls();
  LessonFaults faults(loaded.document, remarks);
  for (std::size_t i = 0; i < loaded.lesson.steps.size(); ++i) {
    const LessonStep& step = loaded.lesson.steps[i];
    const std::string path = fmt::format("/lesson/steps/{}/show", i), &widget = step.show.widget;
    if (!widget.empty() && std::find(controls.begin(), controls.end(), widget) == controls.end()) {
      faults.add(path + "/widget", "the English name of a control", didYouMean(widget, controls));
    }
    const LevelScene begun = played(loaded.level, step.start);
    checkPicks(step.start, fmt::format("/lesson/steps/{}/start", i), begun, vertices, faults);
    if (step.show.play) checkPlay(step, path + "/play", begun, vertices, faults);
  }
}

}  // namespace anamorph
