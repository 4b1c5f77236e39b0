// How the level is shown: choices of whoever looks, not of the level. None of this changes the sculpture, so none of
// it is undone or saved with the level. Names and ranges of the rays are Virtual Ray Tracer's.
#pragma once

#include <optional>

#include "optics/material.h"

namespace anamorph {

enum class RaySource {
  pixels,    ///< the ray trees of the pixel grid's cells
  vertices,  ///< vertex rays: from the eye to the mirror to the sculpture, the deformation itself
};

struct RaySettings {
  bool show = true;
  RaySource source = RaySource::vertices;
  int vertexCount = 24;         ///< sampled evenly over the original's vertices, 1..400
  bool lightRays = false;       ///< also draw the rays to the lights and their shadows
  bool hideNoHit = true;        ///< leave out rays into the background
  bool hideNegligible = false;  ///< leave out rays that give their pixel less than `negligible`
  double negligible = 0.02;     ///< 0..1
  double thickness = 2;         ///< pixels at 100 % UI scale, 0.5..8
  bool thicknessByContribution = false;
  bool alphaByContribution = false;
  double alphaExponent = 1;  ///< 0..2
  bool colorByContribution = false;
  bool animate = false;
  bool sequential = false;  ///< one tree after the other, else all at once
  bool loop = true;
  double speed = 4;  ///< scene units a second, 0..10

  bool operator==(const RaySettings&) const = default;
};

enum class OriginalLook { solid, ghost, hidden };

/// What is shown alone, without rays, camera and lights, for an unobstructed look.
enum class ShownAlone { nothing, original, sculpture, mirror };

struct DisplaySettings {
  OriginalLook originalLook = OriginalLook::ghost;
  bool originalInMirror = false;  ///< whether the 3D view's mirror reflects it
  bool sculpture = true;
  bool mirror = true;
  ShownAlone alone = ShownAlone::nothing;
  bool wireframe = false;      ///< triangle edges on the sculpture
  bool statusColors = false;   ///< vertices that are mapped, missed, hidden
  bool caustic = false;        ///< where the rays from the eye cross beyond a hollow mirror
  bool rtCamera = true;        ///< camera model, frustum and pixel grid
  double screenOpacity = 0.8;  ///< of the pixel grid, 0..1
  bool lightMarkers = true;
  double morph = 1;  ///< 0: the original, 1: the sculpture, between: on the way along the vertex rays
  std::optional<Background> background;  ///< instead of the level's

  bool operator==(const DisplaySettings&) const = default;
};

/// What is really drawn and can be clicked: of what is shown alone nothing is hidden, and of the rest all.
DisplaySettings shown(DisplaySettings settings);

}  // namespace anamorph
