#include "edit/advance.h"

#include <utility>

#include "edit/lesson_run.h"

namespace anamorph {
namespace {

// What depends on the level's parts and may be gone after an edit.
void dropStaleSelection(Editor& editor) {
  const Level& level = editor.session.level();
  const int lights = static_cast<int>(level.lights.size());
  const Selection& selected = editor.selection;
  if (selected.part == Part::light && (selected.index < 0 || selected.index >= lights)) editor.selection = {};
  if (selected.part == Part::controlPoint && !controlPointOf(editor.session.level(), selected))
    editor.selection = {};
  const bool inGrid =
      editor.cell && editor.cell->column < level.grid.columns && editor.cell->row < level.grid.rows;
  if (!inGrid) editor.cell.reset();
  const auto& original = editor.updater.result().original.mesh;
  for (auto* point : {&editor.point, &editor.earlierPoint}) {
    if (*point && original && !isOn(*original, **point)) point->reset();
  }
  if (!editor.point) editor.earlierPoint.reset();
}

bool advanceView(Editor& editor, double seconds) {
  const ViewPose before = editor.pose;
  if (editor.flight) {
    if (editor.lookingThrough) editor.flight->goal = rtCameraPose(editor);
    editor.flightSeconds += seconds;
    editor.pose = editor.flight->poseAt(editor.flightSeconds);
    if (editor.flight->endedAt(editor.flightSeconds)) editor.flight.reset();
  } else if (editor.lookingThrough) {
    editor.pose = rtCameraPose(editor);
  }
  return !(before == editor.pose);
}

}  // namespace

bool advance(Editor& editor, double seconds) {
  editor.status.update(editor.session.level());
  if (auto message = editor.job.update(editor.session))
    editor.status.sayOf(editor.session.level(), std::move(*message));
  dropStaleSelection(editor);
  bool changed = advancePlay(editor, seconds);
  changed |= advanceView(editor, seconds);
  if (editor.rays.animate && editor.rays.show && !editor.animationPaused) {
    editor.animationSeconds += seconds;
    changed = true;
  }
  const bool trees = editor.rays.show && (editor.rays.source == RaySource::pixels || editor.cell);
  const bool original = editor.preview.tab != PreviewTab::reflection;
  changed |= editor.updater.update(editor.session, {editor.preview.size, trees, original});
  return advanceLesson(editor) || changed;
}

}  // namespace anamorph
