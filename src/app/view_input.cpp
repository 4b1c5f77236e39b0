#include "app/view_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/style.h"
#include "viewport/camera_lines.h"
#include "viewport/canvas_lines.h"
#include "viewport/construction_lines.h"
#include "viewport/ray_lines.h"

namespace anamorph {
namespace {

void append(std::vector<Line>& lines, std::vector<Line> more) {
  lines.insert(lines.end(), more.begin(), more.end());
}

std::optional<std::size_t> treeOf(const Editor& editor) {
  if (!editor.cell) return std::nullopt;
  const int columns = editor.updater.result().level.grid.columns;
  return static_cast<std::size_t>(editor.cell->row) * columns + editor.cell->column;
}

// Which rays are shown: those of one pixel when one is picked, else as the settings say.
enum class Shown { none, trees, vertices };

Shown shownRays(const Editor& editor) {
  const LevelResult& result = editor.updater.result();
  if (!editor.rays.show || result.problem || !result.original.mesh) return Shown::none;
  if (editor.cell || editor.rays.source == RaySource::pixels)
    return result.trees ? Shown::trees : Shown::none;
  return editor.point ? Shown::none : Shown::vertices;  // the picked vertex has its construction
}

// Where a looped animation is.
double playTime(const Editor& editor) {
  const double length = ViewInputMaker::animationSeconds(editor), pause = 0.8;
  if (!editor.rays.loop || !(length > 0)) return editor.animationSeconds;
  return std::fmod(editor.animationSeconds, length + pause);
}

}  // namespace

std::vector<Line> makeLines(const Editor& editor, const UiState& ui) {
  std::vector<Line> lines;
  const LevelResult& result = editor.updater.result();
  const Level& level = result.level;
  if (editor.display.rtCamera) {
    const bool selected = editor.selection.part == Part::eye || editor.selection.part == Part::aim;
    append(lines, makeCameraLines(level.camera, level.grid, selected,
                                  editor.cell ? editor.cell : ui.hoveredCell, editor.pose.eye));
  }
  // From the eye the canvas would lie over what is seen in it.
  if (!editor.lookingThrough)
    append(lines, makeCanvasLines(level.optic, editor.selection.part == Part::mirror));
  switch (shownRays(editor)) {
    case Shown::trees:
      append(lines, makeTreeLines(*result.trees, editor.rays, treeOf(editor), playTime(editor)));
      break;
    case Shown::vertices:
      append(lines, makeVertexRayLines(level, *result.original.mesh, editor.rays, playTime(editor)));
      break;
    case Shown::none:
      break;
  }
  if (const auto construction = currentConstruction(editor))
    append(lines, makeConstructionLines(*construction));
  return lines;
}

double ViewInputMaker::animationSeconds(const Editor& editor) {
  const LevelResult& result = editor.updater.result();
  switch (shownRays(editor)) {
    case Shown::trees:
      return treeAnimationSeconds(*result.trees, editor.rays, treeOf(editor));
    case Shown::vertices:
      return vertexRayAnimationSeconds(result.level, *result.original.mesh, editor.rays);
    case Shown::none:
      break;
  }
  return 0;
}

void ViewInputMaker::stepRays(Editor& editor) {
  const int step = std::exchange(editor.rayStep, 0);
  if (step == 0 || !editor.rays.show) return;
  // Step by step makes sense one ray after the other only.
  if (!editor.rays.animate || !editor.rays.sequential) editor.animationSeconds = 0;
  editor.rays.animate = editor.rays.sequential = editor.animationPaused = true;
  const LevelResult& result = editor.updater.result();
  std::vector<double> stops{0};
  if (shownRays(editor) == Shown::trees)
    stops = treeAnimationStops(*result.trees, editor.rays, treeOf(editor));
  if (shownRays(editor) == Shown::vertices) {
    stops = vertexRayAnimationStops(result.level, *result.original.mesh, editor.rays);
  }
  constexpr double same = 1e-6;
  const double now = playTime(editor);
  if (step > 0) {
    const auto next = std::upper_bound(stops.begin(), stops.end(), now + same);
    editor.animationSeconds = next == stops.end() ? stops.back() : *next;
  } else {
    const auto next = std::lower_bound(stops.begin(), stops.end(), now - same);
    editor.animationSeconds = next == stops.begin() ? 0 : *(next - 1);
  }
}

ViewportInput ViewInputMaker::make(Editor& editor, const UiState& ui, bool transparent) {
  const LevelResult& result = editor.updater.result();
  std::vector<Line> lines = makeLines(editor, ui);
  if (!lines_ || *lines_ != lines) lines_ = std::make_shared<const std::vector<Line>>(std::move(lines));
  ViewportInput input;
  input.width = editor.viewWidth;
  input.height = editor.viewHeight;
  input.pose = editor.pose;
  input.level = result.level;
  input.original = result.original;
  input.sculpture = shownSculpture(editor);
  input.display = editor.display;
  if (!input.display.background) input.display.background = skyOf(ui.theme);
  if (editor.lookingThrough && !editor.flight) {
    input.display.rtCamera = false;
    // The ghost would lie exactly over its own reflection.
    if (input.display.originalLook == OriginalLook::ghost) input.display.originalLook = OriginalLook::hidden;
  }
  input.selection = editor.selection;
  input.lines = lines_;
  input.screen = result.screen;
  input.lineScale = ui.scale * (ui.theme == Theme::projector ? 1.6 : 1);
  input.transparent = transparent;
  if (transparent) input.display.lightMarkers = false;
  return input;
}

}  // namespace anamorph
