// "Show me": the move of a step, made before the student's eyes.

#include <algorithm>
#include <variant>

#include "edit/lesson_run.h"
#include "edit/level_edits.h"
#include "edit/replacements.h"
#include "edit/workspace.h"
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
Level levelAt(const StepMove& move, const Level& from, double share) {
  Level level = from;
  const auto towards = [&](auto& value, const auto& goal) {
    if (goal) value = share >= 1 ? *goal : glm::mix(value, *goal, eased(share));
  };
  towards(level.camera.eye, move.eye);
  towards(level.original.placement.position, move.original);
  towards(level.sculpture.depthScale, move.depthScale);
  towards(level.camera.fovDegrees, move.fovDegrees);
  if (move.mirror) {
    const Vector way = *move.mirror - middleOf(from.optic.shape);
    level = moved(level, {Part::mirror}, (share >= 1 ? 1 : eased(share)) * way);
  }
  return level;
}

// To the place in the morph, and from there to the sculpture again.
double morphAt(const StepPlay& play, double share) {
  const double goal = *play.move.morph;
  if (share >= 1) return 1;
  if (goal == 1) return glm::mix(play.morphFrom, 1.0, eased(share));
  return share < 0.5 ? glm::mix(play.morphFrom, goal, eased(2 * share))
                     : glm::mix(goal, 1.0, eased(2 * share - 1));
}

double durationOf(const StepPlay& play) {
  return play.move.morph.value_or(1) < 1 ? 2 * StepPlay::duration : StepPlay::duration;
}

// What cannot be half done is done at once.
Level begun(const StepMove& move, const Workspace& work) {
  Level level = work.session.level();
  if (!move.shape.empty()) {
    level = withBuiltInOriginal(level, numberOf(originalShapes, move.shape), originalBox(work));
  }
  if (!move.mirrorKind.empty()) {
    level.optic.shape =
        mirrorOfKind(numberOf(mirrorShapes, move.mirrorKind), level.optic.shape, level.camera.eye);
  }
  if (move.tolerancePixels) level.sculpture.tolerancePixels = *move.tolerancePixels;
  if (auto* box = std::get_if<BoxShape>(&level.original.shape); box && move.segments) {
    box->segments = *move.segments;
  }
  putRight(level.sculpture.mistakes, move.putRight);
  return level;
}

void playView(Workspace& work, const StepMove& move) {
  if (move.viewEye || move.viewTarget) {
    ViewPose pose = work.pose;
    pose.eye = move.viewEye.value_or(pose.eye);
    pose.target = move.viewTarget.value_or(pose.target);
    pose.up = {0, 0, 1};
    flyTo(work, pose);
  }
  if (move.lookThrough && !work.lookingThrough) toggleLookThrough(work);
  if (!move.preview.empty()) {
    work.preview.tab = static_cast<PreviewTab>(numberOf(previewTabs, move.preview));
  }
  if (!move.rays.empty()) {
    work.rays.show = true;
    work.rays.source = move.rays == "pixels" ? RaySource::pixels : RaySource::vertices;
  }
  if (move.animate) {
    work.rays.show = work.rays.animate = true;
    work.animationPaused = false;
    work.animationSeconds = 0;
  }
  if (move.wireframe) work.display.wireframe = true;
  if (move.vertex && work.studio.products().original.mesh) {
    work.point =
        pickedVertex(*work.studio.products().original.mesh, static_cast<std::uint32_t>(*move.vertex));
  }
  if (move.pixel) work.cell = GridCell{(*move.pixel)[0], (*move.pixel)[1]};
  if (move.undo) work.session.undo();
}

}  // namespace

void playStep(Workspace& work) {
  LessonRun& run = work.lesson;
  if (run.empty() || !run.open().show.play) return;
  finishPlay(work);
  work.session.finishChange();
  playView(work, *run.open().show.play);
  run.play = StepPlay{*run.open().show.play, begun(*run.open().show.play, work), work.session.level(),
                      work.display.morph, 0};
}

bool advancePlay(Workspace& work, double seconds) {
  std::optional<StepPlay>& play = work.lesson.play;
  if (!play) return false;
  if (!(work.session.level() == play->last)) {  // somebody else has taken over
    play.reset();
    return true;
  }
  play->seconds += seconds;
  const double length = durationOf(*play);
  const double share = std::min(1.0, play->seconds / length);
  Level level = levelAt(play->move, play->from, share);
  if (!(level == play->last)) work.session.change(level);
  play->last = std::move(level);
  if (play->move.morph) work.display.morph = morphAt(*play, share);
  if (share >= 1) {
    work.session.finishChange();
    play.reset();
  }
  return true;
}

void finishPlay(Workspace& work) {
  if (work.lesson.play) advancePlay(work, durationOf(*work.lesson.play));
}

}  // namespace anamorph
