// Built-in originals. All are closed, outward-oriented and welded; sizes in scene units, z up, centred on the
// origin. Segment counts say how fine they are: the thesis' lesson is that this matters (section 4.3).
// Arguments outside the stated ranges are programming errors.
#pragma once

#include "geometry/mesh.h"

namespace anamorph {

/// A box with `segments` >= 1 quads along every edge, each cut in two triangles. Size (6, 2, 2) with 32
/// segments is the thesis' box: 6146 vertices, 12288 triangles. One segment: 8 vertices, 12 triangles.
Mesh makeBox(const Vector& size, int segments);

/// Latitude-longitude sphere; `segments` >= 3 around, half as many (at least 2) from pole to pole.
Mesh makeSphere(double radius, int segments);

/// The (p, q) torus knot, p and q without a common divisor: p times around the axis of a torus of radius 1, q
/// times around its tube. `tubeRadius` is that of the knot itself. Scaled to fit a box of side 2; `segments`
/// >= 3 along the knot, `sides` >= 3 around it.
Mesh makeTorusKnot(int p, int q, double tubeRadius, int segments, int sides);

/// A block letter F of the given height (z), in the xz plane, to be read looking along +y. It has no mirror
/// symmetry, so it shows what a mirror does. Every edge of its blocks is cut into `segments` >= 1.
Mesh makeLetterF(double height, int segments);

/// A pawn turned on a lathe about the z axis, of the given height; `segments` >= 3 around.
Mesh makePawn(double height, int segments);

}  // namespace anamorph
