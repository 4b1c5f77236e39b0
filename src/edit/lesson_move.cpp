#include "edit/lesson_move.h"

#include <algorithm>
#include <utility>

#include "edit/level_edits.h"
#include "edit/replacements.h"
#include "level/freeze.h"
#include "level/level_fields.h"
#include "level/move_numbers.h"

namespace anamorph {
namespace {

// The number of a name in one of the lists of level_fields.h.
template <typename Names>
std::size_t numberOf(const Names& names, const std::string& name) {
  return static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

void pickVertex(Editor& editor, int vertex) {
  const auto& mesh = editor.updater.result().original.mesh;
  if (mesh) pickPoint(editor, pickedVertex(*mesh, static_cast<std::uint32_t>(vertex)));
}

void showRays(Editor& editor, const StepMove& move) {
  if (!move.rays.empty()) {
    editor.rays.show = true;
    editor.rays.source = move.rays == "pixels" ? RaySource::pixels : RaySource::vertices;
  }
  if (move.animate) {
    restRays(editor);
    editor.rays.show = editor.rays.animate = true;
  }
}

}  // namespace

double eased(double t) {
  return t * t * (3 - 2 * t);
}

Level levelAt(const StepMove& move, const Level& begun, double fraction) {
  Level level = begun;
  const double part = eased(fraction);
  setNumbers(level, move, part);
  if (move.controlPoint && move.controlBy) {
    level = moved(level, {Part::controlPoint, *move.controlPoint}, part * *move.controlBy);
  }
  if (move.mirror) {
    const Vector way = *move.mirror - middleOf(begun.optic.shape());
    level = moved(level, {Part::mirror}, part * way);
  }
  return level;
}

Level begun(const StepMove& move, Level level, const Box& box) {
  if (!move.shape.empty()) level = withBuiltInOriginal(level, numberOf(originalShapes, move.shape), box);
  setSwitches(level, move);
  if (!move.freeze) return level;
  level.sculpture.depthScale = move.depthScale.value_or(level.sculpture.depthScale);
  level.sculpture.depthOffset = move.depthOffset.value_or(level.sculpture.depthOffset);
  return frozen(std::move(level));
}

void moveView(Editor& editor, const StepMove& move) {
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
  showRays(editor, move);
  if (move.wireframe) editor.display.wireframe = true;
  if (move.caustic) editor.display.caustic = true;
  if (move.controlPoint) editor.selection = {Part::controlPoint, *move.controlPoint};
  if (move.vertex) pickVertex(editor, *move.vertex);
  if (move.ends) {
    for (const int vertex : *move.ends) pickVertex(editor, vertex);
  }
  if (move.pixel) pickCell(editor, GridCell{(*move.pixel)[0], (*move.pixel)[1]});
  if (move.undo) editor.session.undo();
}

}  // namespace anamorph
