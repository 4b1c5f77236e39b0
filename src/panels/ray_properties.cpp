// Which rays are drawn, and how: Virtual Ray Tracer's settings.

#include "panels/panels.h"
#include "panels/widgets.h"

namespace anamorph {
namespace {

void styleRows(RaySettings& rays) {
  sliderRow("Thickness", rays.thickness, {limits::rayThickness, 0.1, "%.1f px"});
  checkRow("Thicker if they matter more", rays.thicknessByContribution,
           "By how much a ray gives to its pixel.");
  checkRow("Fainter if they matter less", rays.alphaByContribution, "By how much a ray gives to its pixel.");
  if (rays.alphaByContribution)
    sliderRow("Exponent", rays.alphaExponent, {limits::rayExponent, 0.01, "%.2f"});
  checkRow("In the colour they bring", rays.colorByContribution, "Instead of the colour of their kind.");
}

void animationRows(Editor& editor) {
  RaySettings& rays = editor.rays;
  if (checkRow("Animate", rays.animate, "The rays grow from the eye.")) editor.animationSeconds = 0;
  if (!rays.animate) return;
  if (checkRow("One after the other", rays.sequential)) editor.animationSeconds = 0;
  checkRow("Loop", rays.loop, "Begin anew at the end.");
  sliderRow("Speed", rays.speed, {limits::raySpeed, 0.1, "%.1f / s"}, "Scene units a second.");
  if (wideButton(editor.animationPaused ? "Go on" : "Pause"))
    editor.animationPaused = !editor.animationPaused;
  if (wideButton("From the start")) editor.animationSeconds = 0;
}

}  // namespace

void drawRayProperties(Editor& editor, UiState& ui) {
  RaySettings& rays = editor.rays;
  if (section(ui, "Rays")) {
    checkRow("Show rays", rays.show);
    int source = static_cast<int>(rays.source);
    if (choiceRow("Which", source, {"Through the pixels", "Through vertices"},
                  "Pixels: the rays that make the image. Vertices: the rays that make the sculpture.")) {
      rays.source = static_cast<RaySource>(source);
      editor.animationSeconds = 0;
    }
    if (rays.source == RaySource::vertices)
      integerRow("How many", rays.vertexCount, limits::drawnVertexRays,
                 "Spread evenly over the original's vertices.");
    checkRow("To the lights too", rays.lightRays, "Rays that ask whether a light is free, and shadow rays.");
    checkRow("Caustic", editor.display.caustic,
             "Where neighbouring rays cross beyond a hollow mirror: two surfaces, drawn as dots.");
    checkRow("Hide rays into the sky", rays.hideNoHit);
    checkRow("Hide negligible rays", rays.hideNegligible, "That give their pixel less than the share below.");
    if (rays.hideNegligible) sliderRow("Share", rays.negligible, {limits::fractions, 0.001, "%.3f"});
  }
  if (section(ui, "Style")) styleRows(rays);
  if (section(ui, "Animation")) animationRows(editor);
}

}  // namespace anamorph
