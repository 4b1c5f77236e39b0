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

std::optional<std::size_t> treeOf(const Workspace& work) {
  if (!work.cell) return std::nullopt;
  const Camera& camera = work.studio.products().level.camera;
  return static_cast<std::size_t>(work.cell->row) * camera.gridColumns + work.cell->column;
}

// Which rays are shown: those of one pixel when one is picked, else as the settings say.
enum class Shown { none, trees, vertices };

Shown shownRays(const Workspace& work) {
  const Products& products = work.studio.products();
  if (!work.rays.show || products.problem || !products.original.mesh) return Shown::none;
  if (work.cell || work.rays.source == RaySource::pixels) return products.trees ? Shown::trees : Shown::none;
  return work.point ? Shown::none : Shown::vertices;  // the picked vertex has its construction
}

// Where a looped animation is.
double playTime(const Workspace& work) {
  const double length = ViewInputMaker::animationSeconds(work), pause = 0.8;
  if (!work.rays.loop || !(length > 0)) return work.animationSeconds;
  return std::fmod(work.animationSeconds, length + pause);
}

}  // namespace

std::vector<Line> makeLines(const Workspace& work, const UiState& ui) {
  std::vector<Line> lines;
  const Products& products = work.studio.products();
  const Level& level = products.level;
  if (work.display.rtCamera) {
    const bool selected = work.selection.part == Part::eye || work.selection.part == Part::aim;
    append(lines,
           makeCameraLines(level.camera, selected, work.cell ? work.cell : ui.hoveredCell, work.pose.eye));
  }
  // From the eye the canvas would lie over what is seen in it.
  if (!work.lookingThrough) append(lines, makeCanvasLines(level.optic, work.selection.part == Part::mirror));
  switch (shownRays(work)) {
    case Shown::trees:
      append(lines, makeTreeLines(*products.trees, work.rays, treeOf(work), playTime(work)));
      break;
    case Shown::vertices:
      append(lines, makeVertexRayLines(level, *products.original.mesh, work.rays, playTime(work)));
      break;
    case Shown::none:
      break;
  }
  if (const auto construction = currentConstruction(work))
    append(lines, makeConstructionLines(*construction));
  return lines;
}

double ViewInputMaker::animationSeconds(const Workspace& work) {
  const Products& products = work.studio.products();
  switch (shownRays(work)) {
    case Shown::trees:
      return treeAnimationSeconds(*products.trees, work.rays, treeOf(work));
    case Shown::vertices:
      return vertexRayAnimationSeconds(products.level, *products.original.mesh, work.rays);
    case Shown::none:
      break;
  }
  return 0;
}

void ViewInputMaker::stepRays(Workspace& work) {
  const int step = std::exchange(work.rayStep, 0);
  if (step == 0 || !work.rays.show) return;
  // Step by step makes sense one ray after the other only.
  if (!work.rays.animate || !work.rays.sequential) work.animationSeconds = 0;
  work.rays.animate = work.rays.sequential = work.animationPaused = true;
  const Products& products = work.studio.products();
  std::vector<double> stops{0};
  if (shownRays(work) == Shown::trees) stops = treeAnimationStops(*products.trees, work.rays, treeOf(work));
  if (shownRays(work) == Shown::vertices) {
    stops = vertexRayAnimationStops(products.level, *products.original.mesh, work.rays);
  }
  constexpr double same = 1e-6;
  const double now = playTime(work);
  if (step > 0) {
    const auto next = std::upper_bound(stops.begin(), stops.end(), now + same);
    work.animationSeconds = next == stops.end() ? stops.back() : *next;
  } else {
    const auto next = std::lower_bound(stops.begin(), stops.end(), now - same);
    work.animationSeconds = next == stops.begin() ? 0 : *(next - 1);
  }
}

ViewportInput ViewInputMaker::make(Workspace& work, const UiState& ui, bool transparent) {
  const Products& products = work.studio.products();
  std::vector<Line> lines = makeLines(work, ui);
  if (!lines_ || *lines_ != lines) lines_ = std::make_shared<const std::vector<Line>>(std::move(lines));
  ViewportInput input;
  input.width = work.viewWidth;
  input.height = work.viewHeight;
  input.pose = work.pose;
  input.level = products.level;
  input.original = products.original;
  input.sculpture = shownSculpture(work);
  input.display = work.display;
  if (!input.display.background) input.display.background = skyOf(ui.preferences.theme);
  if (work.lookingThrough && !work.flight) {
    input.display.rtCamera = false;
    // The ghost would lie exactly over its own reflection.
    if (input.display.originalLook == OriginalLook::ghost) input.display.originalLook = OriginalLook::hidden;
  }
  input.selection = work.selection;
  input.lines = lines_;
  input.screen = products.screen;
  input.lineScale = ui.scale * (ui.preferences.theme == Theme::projector ? 1.6 : 1);
  input.transparent = transparent;
  if (transparent) input.display.lightMarkers = false;
  return input;
}

}  // namespace anamorph
