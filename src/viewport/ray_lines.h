// Rays as lines: which of them are drawn, in which colour and style, and how far they have come while they
// are animated.
#pragma once

#include <optional>
#include <vector>

#include "edit/display_settings.h"
#include "geometry/mesh.h"
#include "level/level.h"
#include "raytrace/tracer.h"
#include "viewport/line.h"

namespace anamorph {

/// How a kind of ray is drawn (raytrace/ray_looks.h): from, to and width are the caller's.
Line rayStyle(RayKind kind);

/// The segments of ray trees that the settings show; `only` restricts them to one tree. With animation, rays
/// have grown for `seconds` at the settings' speed.
std::vector<Line> makeTreeLines(const std::vector<RayTree>& trees, const RaySettings& settings,
                                std::optional<std::size_t> only, double seconds);

/// The vertex rays of `settings.vertexCount` vertices of the original (in scene coordinates), evenly over its
/// list.
std::vector<Line> makeVertexRayLines(const LevelScene& level, const Mesh& original, const RaySettings& settings,
                                     double seconds);

/// How many seconds the animation of these takes; 0 when nothing moves.
double treeAnimationSeconds(const std::vector<RayTree>& trees, const RaySettings& settings,
                            std::optional<std::size_t> only);
double vertexRayAnimationSeconds(const LevelScene& level, const Mesh& original, const RaySettings& settings);

/// The seconds at which a piece of a ray ends, each once and in order: where an animation that is stepped by
/// hand stops. The first is 0.
std::vector<double> treeAnimationStops(const std::vector<RayTree>& trees, const RaySettings& settings,
                                       std::optional<std::size_t> only);
std::vector<double> vertexRayAnimationStops(const LevelScene& level, const Mesh& original,
                                            const RaySettings& settings);

}  // namespace anamorph
