// "Show me": the move of a step, made before the student's eyes.

#include <algorithm>
#include <utility>
#include <variant>

#include "edit/editor.h"
#include "edit/lesson_run.h"
#include "edit/level_edits.h"
#include "edit/replacements.h"
#include "level/freeze.h"
#include "level/level_fields.h"

namespace anamorph {
namespace {

// The number of a name in one of the lists of level_fields.h.
template <typename Names>
std::size_t numberOf(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

void putRight(Mistakes& mistakes, const std::string& which) {
  if (which == "direction") mistakes.direction = false;
  if (which == "distance") mistakes.distance = false;
  if (which == "normal") mistakes.normal = false;
}

// Slow at both ends.
double eased(double t) {
  return t * t * (3 - 2 * t);
}

// The level so far into the move, 0..1.
Level levelAt(const StepMove& move, const Level& from, double fraction) {
  Level level = from;
  const auto towards = [&](auto& value, const auto& goal) {
    if (goal) value = fraction >= 1 ? *goal : glm::mix(value, *goal, eased(fraction));
  };
  towards(level.camera.eye, move.eye);
  towards(level.original.placement.position, move.original);
  towards(level.sculpture.depthScale, move.depthScale);
  towards(level.camera.fovDegrees, move.fovDegrees);
  if (move.mirror) {
    const Vector way = *move.mirror - middleOf(from.optic.shape());
    level = moved(level, {Part::mirror}, (fraction >= 1 ? 1 : eased(fraction)) * way);
  }
  return level;
}

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

// What cannot be half done is done at once.
Level begun(const StepMove& move, const Editor& editor) {
  Level level = editor.session.level();
  if (!move.shape.empty()) {
    level = withBuiltInOriginal(level, numberOf(originalShapes, move.shape), originalBox(editor));
  }
  if (!move.mirrorKind.empty()) {
    level.optic.shape() =
        mirrorOfKind(numberOf(shapeNames(), move.mirrorKind), level.optic.shape(), level.camera.eye);
  }
  if (move.tolerancePixels) level.sculpture.tolerancePixels = *move.tolerancePixels;
  if (auto* box = std::get_if<BoxShape>(&level.original.shape); box && move.segments) {
    box->segments = *move.segments;
  }
  putRight(level.sculpture.mistakes, move.putRight);
  if (!move.freeze) return level;
  level.sculpture.depthScale = move.depthScale.value_or(level.sculpture.depthScale);
  return frozen(std::move(level));
}

void playView(Editor& editor, const StepMove& move) {
  if (move.viewEye || move.viewTarget) {
    ViewPose pose = editor.pose;
    pose.eye = move.viewEye.value_or(pose.eye);
    pose.target = move.viewTarget.value_or(pose.target);
    pose.up = {0, 0, 1};
    flyTo(editor, pose);
  }
  if (move.lookThrough && !editor.lookingThrough) toggleLookThrough(editor);
  if (!move.preview.empty()) {
    editor.preview.tab = static_cast<PreviewTab>(numberOf(previewTabs, move.preview));
  }
  if (!move.rays.empty()) {
    editor.rays.show = true;
    editor.rays.source = move.rays == "pixels" ? RaySource::pixels : RaySource::vertices;
  }
  if (move.animate) {
    editor.rays.show = editor.rays.animate = true;
    editor.animationPaused = false;
    editor.animationSeconds = 0;
  }
  if (move.wireframe) editor.display.wireframe = true;
  if (move.vertex && editor.updater.result().original.mesh) {
    editor.point =
        pickedVertex(*editor.updater.result().original.mesh, static_cast<std::uint32_t>(*move.vertex));
  }
  if (move.pixel) editor.cell = GridCell{(*move.pixel)[0], (*move.pixel)[1]};
  if (move.undo) editor.session.undo();
}

}  // namespace

void playStep(Editor& editor) {
  LessonRun& run = editor.lesson;
  if (run.empty() || !run.open().show.play) return;
  finishPlay(editor);
  editor.session.finishChange();
  playView(editor, *run.open().show.play);
  run.play = StepPlay{*run.open().show.play, begun(*run.open().show.play, editor), editor.session.level(),
                      editor.display.morph, 0};
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
