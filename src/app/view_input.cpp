#include "app/view_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/style.h"
#include "viewport/camera_lines.h"
#include "viewport/canvas_lines.h"
#include "viewport/caustic_lines.h"
#include "viewport/construction_lines.h"

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

// Where a looped animation is.
double playTime(const Editor& editor, const ShownRays& rays) {
  const double length = rays.animationSeconds(editor.rays), pause = 0.8;
  if (!editor.rays.loop || !(length > 0)) return editor.animationSeconds;
  return std::fmod(editor.animationSeconds, length + pause);
}

}  // namespace

ShownRays::ShownRays(const Editor& editor) {
  const LevelResult& result = editor.updater.result();
  if (!editor.rays.show || result.problem || !result.source) return;
  if (editor.cell || editor.rays.source == RaySource::pixels) {
    trees_ = result.trees;
    tree_ = treeOf(editor);
  } else if (!editor.point) {  // the picked vertex has its construction
    vertexRays_ = sampleVertexRays(makeVertexMap(result.level), *result.source, editor.rays.vertexCount);
  }
}

std::vector<Line> ShownRays::lines(const RaySettings& settings, double seconds) const {
  return trees_ ? makeTreeLines(*trees_, settings, tree_, seconds)
                : makeVertexRayLines(vertexRays_, settings, seconds);
}

double ShownRays::animationSeconds(const RaySettings& settings) const {
  return trees_ ? treeAnimationSeconds(*trees_, settings, tree_)
                : vertexRayAnimationSeconds(vertexRays_, settings);
}

std::vector<double> ShownRays::stops(const RaySettings& settings) const {
  return trees_ ? treeAnimationStops(*trees_, settings, tree_)
                : vertexRayAnimationStops(vertexRays_, settings);
}

void stepRays(Editor& editor, const ShownRays& rays) {
  const int step = std::exchange(editor.rayStep, 0);
  if (step == 0 || !editor.rays.show) return;
  // Step by step makes sense one ray after the other only.
  if (!editor.rays.animate || !editor.rays.sequential) editor.animationSeconds = 0;
  editor.rays.animate = editor.rays.sequential = editor.animationPaused = true;
  const std::vector<double> stops = rays.stops(editor.rays);
  constexpr double same = 1e-6;
  const double now = playTime(editor, rays);
  if (step > 0) {
    const auto next = std::upper_bound(stops.begin(), stops.end(), now + same);
    editor.animationSeconds = next == stops.end() ? stops.back() : *next;
  } else {
    const auto next = std::lower_bound(stops.begin(), stops.end(), now - same);
    editor.animationSeconds = next == stops.begin() ? 0 : *(next - 1);
  }
}

const std::vector<Line>& CausticStage::at(const LevelResult& result) {
  return memo_.get({makeVertexMap(result.level), result.source}, [](const Input& input) {
    constexpr std::size_t bundles = 600;
    return makeCausticLines(findCaustic(input.map, input.source->positions, bundles));
  });
}

std::vector<Line> makeLines(Editor& editor, const UiState& ui, const ShownRays& rays, CausticStage& caustic) {
  const LevelResult& result = editor.updater.result();
  const LevelScene& level = result.level;
  const DisplaySettings display = shown(editor.display);
  std::vector<Line> lines;
  if (display.rtCamera) {
    const bool selected = editor.selection.part == Part::eye || editor.selection.part == Part::aim;
    append(lines, makeCameraLines(level.camera, level.grid, selected,
                                  editor.cell ? editor.cell : ui.hoveredCell, editor.pose.eye));
  }
  // From the eye the canvas would lie over what is seen in it.
  if (!editor.lookingThrough && display.mirror)
    append(lines, makeCanvasLines(level.optic, isOfMirror(editor.selection)));
  if (display.alone != ShownAlone::nothing) return lines;
  append(lines, rays.lines(editor.rays, playTime(editor, rays)));
  if (editor.display.caustic && !result.problem && result.source) append(lines, caustic.at(result));
  for (const auto* construction : {&currentConstruction(editor), &earlierConstruction(editor)}) {
    if (*construction) append(lines, makeConstructionLines(**construction));
  }
  return lines;
}

ViewportInput ViewInputMaker::make(Editor& editor, const UiState& ui, const ShownRays& rays,
                                   bool transparent) {
  const LevelResult& result = editor.updater.result();
  std::vector<Line> lines = makeLines(editor, ui, rays, caustic_);
  if (!lines_ || *lines_ != lines) lines_ = std::make_shared<const std::vector<Line>>(std::move(lines));
  ViewportInput input;
  input.width = editor.viewWidth;
  input.height = editor.viewHeight;
  input.pose = editor.pose;
  input.level = result.level;
  input.original = result.original;
  input.sculpture = shownSculpture(editor);
  input.display = shown(editor.display);
  if (!input.display.background) input.display.background = skyOf(ui.theme);
  if (editor.lookingThrough && !editor.flight) {
    input.display.rtCamera = false;
    // The ghost would lie exactly over its own reflection.
    if (input.display.originalLook == OriginalLook::ghost) input.display.originalLook = OriginalLook::hidden;
  }
  input.selection = editor.selection;
  input.lines = lines_;
  input.screen = result.screen;
  // For an audience thicker; large signs are thick enough.
  input.lineScale = std::max(ui.scale, ui.theme == Theme::projector ? 1.6 : 1.0);
  input.transparent = transparent;
  if (transparent) input.display.lightMarkers = false;
  return input;
}

}  // namespace anamorph
