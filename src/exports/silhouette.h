// The outline of a mesh seen from far away: what is covered when its triangles are laid flat.
//
//    triangles --fill--> cells of a fine grid --walk around--> loops --straighten--> outlines
//
// A grid takes any mesh: open ones, overlapping parts, holes. Outlines are right to one cell, a 1500th of the
// longer side: less than the width of a printed line. Loops run counter-clockwise around what is covered, so
// holes run clockwise.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include "geometry/mesh.h"

namespace anamorph {

using Loop = std::vector<glm::dvec2>;

/// The loops around the triangles between these points; empty without triangles.
std::vector<Loop> makeSilhouette(std::span<const glm::dvec2> points, std::span<const Triangle> triangles,
                                 int resolution = 1500);

}  // namespace anamorph
