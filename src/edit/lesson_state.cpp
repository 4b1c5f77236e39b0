#include "edit/lesson_state.h"

namespace anamorph {
namespace {

constexpr int requiredPoints = 10, optionalPoints = 5;

}  // namespace

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

bool isOnlyRead(const LessonStep& step) {
  return step.done.empty() && !step.question;
}

bool isAnswered(const LessonRun& run) {
  const auto& question = run.open().question;
  return !question || (run.answer && question->answers.at(*run.answer).right);
}

bool isDone(const Lesson& lesson, const LessonStep& step, const LessonProgress& progress) {
  const auto found = progress.find(lesson.id);
  return found != progress.end() && found->second.count(step.id) > 0;
}

}  // namespace anamorph
