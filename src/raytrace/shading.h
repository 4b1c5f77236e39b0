// The colours of the studio: how a surface answers one light (Phong), what lies behind everything, and the
// few things that make the picture readable without changing what it says: grid lines on the ground, the
// mirror's bright edge.
#pragma once

#include "optics/material.h"
#include "raytrace/scene.h"
#include "raytrace/scene_hit.h"

namespace anamorph {

/// What is seen along a direction that meets nothing.
Color backgroundColor(const Background& background, const Direction& direction);

/// The share of a light's colour that the surface sends towards the eye: diffuse and specular, without
/// shadow. `toLight` and `toEye` are directions away from the hit. 0 for a light behind the surface.
Color phongResponse(const Material& material, const SceneHit& hit, const Direction& toLight,
                    const Direction& toEye);

/// The ground's material at a hit, darkened along grid lines. `footprint` is the width of a pixel there,
/// scene units: lines thinner than it fade instead of flickering.
Material groundMaterial(const Ground& ground, const Point& point, double footprint);

/// How much of the mirror's bright edge is seen here: 1 on its border and where it is seen edge-on, 0 inside.
double mirrorRim(const Shape& shape, const Point& point, double cosine);

}  // namespace anamorph
