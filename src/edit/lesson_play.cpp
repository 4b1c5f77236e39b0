// "Do it": the move of a step, made before the student's eyes.

#include <algorithm>
#include <variant>

#include "base/language.h"
#include "edit/lesson_move.h"
#include "edit/lesson_run.h"
#include "edit/lesson_start.h"

namespace anamorph {
namespace {

// To the place in the morph, and from there to the sculpture again.
double morphAt(const StepPlay& play, double fraction) {
  const double goal = *play.move.morph;
  if (fraction >= 1) return 1;
  if (goal == 1) return glm::mix(play.morphFrom, 1.0, eased(fraction));
  return fraction < 0.5 ? glm::mix(play.morphFrom, goal, eased(2 * fraction))
                        : glm::mix(goal, 1.0, eased(2 * fraction - 1));
}

double durationOf(const StepPlay& play) {
  return play.move.morph.value_or(1) < 1 ? 2 * StepPlay::duration : StepPlay::duration;
}

void answerRight(Editor& editor) {
  const auto& question = editor.lesson.open().question;
  if (!question) return;
  const auto right = std::find_if(question->answers.begin(), question->answers.end(),
                                  [](const StepAnswer& answer) { return answer.right; });
  answerStep(editor, static_cast<std::size_t>(right - question->answers.begin()));
}

// Numbers of vertices are those of the step's own original, and only a box has segments.
bool isForOriginal(const Editor& editor, const StepMove& move) {
  const auto& shape = editor.session.level().original.shape;
  if (move.segments && !std::holds_alternative<BoxShape>(shape)) return false;
  return !(move.vertex || move.ends) || shape == startOf(editor, editor.lesson.step).original.shape;
}

}  // namespace

void playStep(Editor& editor) {
  LessonRun& run = editor.lesson;
  if (run.empty() || !run.open().show.play) return;
  finishPlay(editor);
  const StepMove& move = *run.open().show.play;
  const Level& level = editor.session.level();
  if (!isForOriginal(editor, move)) {
    editor.status.sayOf(
        level,
        tr("This move needs the level's own original, and you have another one: Again brings it back."));
    return;
  }
  answerRight(editor);
  editor.session.finishChange();
  moveView(editor, move);
  run.play = StepPlay{
      move, begun(move, level, originalBox(editor)), level, editor.display.morph, editor.preview.wipe, 0};
}

std::vector<Point> pointsOfMove(const Editor& editor) {
  const LessonRun& run = editor.lesson;
  const auto& mesh = editor.updater.result().original.mesh;
  if (run.empty() || !run.open().show.play || !mesh || !isForOriginal(editor, *run.open().show.play))
    return {};
  const StepMove& move = *run.open().show.play;
  std::vector<Point> points;
  const auto add = [&](int vertex) {
    const auto i = static_cast<std::size_t>(vertex);
    if (i < mesh->positions.size()) points.push_back(mesh->positions[i]);
  };
  if (move.vertex) add(*move.vertex);
  if (move.ends) std::for_each(move.ends->begin(), move.ends->end(), add);
  return points;
}

bool advancePlay(Editor& editor, double seconds) {
  std::optional<StepPlay>& play = editor.lesson.play;
  if (!play) return false;
  if (!(editor.session.level() == play->last)) {  // somebody else has taken over
    play.reset();
    return true;
  }
  play->seconds += seconds;
  const double length = durationOf(*play);
  const double fraction = std::min(1.0, play->seconds / length);
  Level level = levelAt(play->move, play->from, fraction);
  if (!(level == play->last)) editor.session.change(level);
  play->last = std::move(level);
  if (play->move.morph) editor.display.morph = morphAt(*play, fraction);
  if (play->move.wipe) editor.preview.wipe = glm::mix(play->wipeFrom, *play->move.wipe, eased(fraction));
  if (fraction >= 1) {
    editor.session.finishChange();
    play.reset();
  }
  return true;
}

void finishPlay(Editor& editor) {
  if (editor.lesson.play) advancePlay(editor, durationOf(*editor.lesson.play));
}

}  // namespace anamorph
