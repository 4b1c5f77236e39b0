// The RT camera: eye, aim, field of view, pixel grid, and how it traces.

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "base/language.h"
#include "panels/help_buttons.h"
#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

constexpr NumberRange coordinates{limits::coordinates, 0.05, "%.2f"};

// Below the eye's place: what is wrong with it.
std::string eyeProblem(const Level& level) {
  const Shape& mirror = level.optic.shape();
  return findShapeProblem(mirror) ? "" : findEyeProblem(mirror, level.camera.eye).value_or("");
}

void liftRow(Editor& editor, const UiState& ui) {
  const auto& match = editor.updater.result().match;
  const double hidden = match ? match->report.hiddenShare : 0;
  if (hidden > 0) {
    quietText(
        ui,
        trFormat("The sculpture hides {:.1f} % of its own reflection.", std::max(0.1, 100 * hidden)).c_str());
  }
  liftButton(editor);
}

bool cameraRows(Editor& editor, const UiState& ui, Level& level) {
  Camera& camera = level.camera;
  bool changed = false;
  if (section(ui, "RT camera")) {
    changed |= vectorRow("Eye", camera.eye, coordinates,
                         level.sculpture.frozen
                             ? "Where the viewer's eye is. The sculpture is frozen and does not follow it."
                             : "Where the viewer's eye is. The sculpture is made for this one point.");
    problemText(ui, eyeProblem(level));
    changed |= vectorRow("Looks at", camera.target, coordinates,
                         "The middle of its image. Where it looks does not change the sculpture.");
    changed |= sliderRow("Field of view", camera.fovDegrees, {limits::fieldOfView.panel, 0.1, "%.1f°"},
                         "Of the image, from its lower to its upper edge.");
    liftRow(editor, ui);
  }
  if (section(ui, "Pixel grid")) {
    changed |= integerRow("Columns", level.grid.columns, limits::gridCells,
                          "Cells from left to right. Each is one pixel with its own ray.");
    changed |= integerRow("Rows", level.grid.rows, limits::gridCells, "Cells from top to bottom.");
    changed |= sliderRow("Distance", level.grid.distance, {limits::gridDistance.panel, 0.01, "%.2f"},
                         "How far in front of the eye the grid is drawn. It only shows the image: nothing "
                         "else depends on it.");
  }
  return changed;
}

bool tracingRows(const UiState& ui, TracingSettings& tracing) {
  bool changed = false;
  if (!section(ui, "Ray tracer", false)) return false;
  changed |= integerRow("Recursion depth", tracing.maxDepth, limits::reflections,
                        "How many reflections in a row are followed. With 0 the mirror shows only the sky.");
  changed |= checkRow("Shadows", tracing.shadows, "Whether a ray to each light has to be free.");
  changed |= integerRow("Samples", tracing.samplesPerAxis, limits::samplesPerAxis,
                        "Along each side of a pixel: 2 means 4 rays a pixel, which smooths edges.");
  return changed;
}

}  // namespace

void drawEyeProperties(Editor& editor, UiState& ui) {
  Level level = editor.session.level();
  bool changed = cameraRows(editor, ui, level);
  if (section(ui, "Shown as")) {
    checkRow("Camera, frustum and grid", editor.display.rtCamera, "In the 3D view.");
    sliderRow("Grid opacity", editor.display.screenOpacity, {limits::fractions, 0.01, "%.2f"},
              "Of the image on the pixel grid.");
  }
  changed |= tracingRows(ui, level.tracing);
  if (changed) editor.session.change(std::move(level));
}

}  // namespace anamorph
