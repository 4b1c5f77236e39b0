// How each kind of ray looks and what it is called: one table for the 3D view, its legend and ray files. Every kind
// has a colour and a line style of its own, so that nobody depends on telling colours apart.
#pragma once

#include <array>
#include <cstddef>

#include "math/palette.h"
#include "raytrace/tracer.h"

namespace anamorph {

enum class LineStyle { solid, dashed, dotted };

struct LineLook {
  const char* legend;  ///< its English name there; null: it has no line of its own
  Rgb color;
  LineStyle style = LineStyle::solid;
  bool arrow = false;  ///< in its middle
  double alpha = 1;
};

struct RayLook {
  RayKind kind;
  const char* fileName;  ///< of its group in a file of rays
  LineLook line;
};

inline constexpr std::array rayLooks{
    RayLook{RayKind::camera, "camera_rays", {"from the eye", palette::rayFromEye, LineStyle::solid, true}},
    RayLook{
        RayKind::reflected, "reflected_rays", {"reflected", palette::rayReflected, LineStyle::dashed, true}},
    RayLook{RayKind::light, "light_rays", {"to a light", palette::rayToLight, LineStyle::dotted, true}},
    RayLook{RayKind::shadow, "shadow_rays", {"in shadow", palette::rayInShadow, LineStyle::dotted, false}},
    RayLook{
        RayKind::noHit, "no_hit_rays", {"meets nothing", palette::rayIntoSky, LineStyle::solid, false, 0.5}},
};

constexpr const RayLook& lookOf(RayKind kind) {
  return rayLooks[static_cast<std::size_t>(kind)];
}

// One look for each kind of ray, in their order.
static_assert([] {
  for (std::size_t i = 0; i < rayLooks.size(); ++i) {
    if (rayLooks[i].kind != static_cast<RayKind>(i)) return false;
  }
  return rayLooks.back().kind == RayKind::noHit;
}());

/// The lines of a vertex's construction that are no rays: the normal, and the way light only seems to come.
inline constexpr LineLook normalLook{"normal", palette::normal, LineStyle::dotted, true};
inline constexpr LineLook virtualRayLook{nullptr, palette::virtualRay, LineStyle::dotted};

}  // namespace anamorph
