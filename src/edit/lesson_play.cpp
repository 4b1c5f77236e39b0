// "Do it": the move of a step, made before the student's eyes.

#include <algorithm>

#include "edit/lesson_move.h"
#include "edit/lesson_run.h"

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

}  // namespace

void playStep(Editor& editor) {
  LessonRun& run = editor.lesson;
  if (run.empty() || !run.open().show.play) return;
  finishPlay(editor);
  answerRight(editor);
  editor.session.finishChange();
  const StepMove& move = *run.open().show.play;
  moveView(editor, move);
  const Level& level = editor.session.level();
  run.play = StepPlay{
      move, begun(move, level, originalBox(editor)), level, editor.display.morph, editor.preview.wipe, 0};
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
