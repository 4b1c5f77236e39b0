// Whether two triangles go through each other.
//
//        \   B   /          Two planes meet in a line. The triangles cross when they share a piece of it that
//     A ==\==*==/====       has a length; then an edge of one passes through the other (the star). Touching
//          \   /            in a corner or along an edge is not crossing. In one plane: a common area is.
//           \ /
//
// The sign of a tetrahedron's volume decides on which side of a plane a point lies. It is computed in double
// with Shewchuk's bound of its error (1997, "Adaptive precision floating-point arithmetic"); what is nearer
// to the plane than that counts as lying in it.
#pragma once

#include <array>

#include "math/vec.h"

namespace anamorph {

using TriangleCornerPoints = std::array<Point, 3>;

/// On which side of the plane a b c (counter-clockwise seen from side 1) d lies: 1, -1, or 0 for in the
/// plane.
int sideOf(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether the triangles share a line with a length in their insides, or an area in one plane.
bool trianglesCross(const TriangleCornerPoints& s, const TriangleCornerPoints& t);

}  // namespace anamorph
