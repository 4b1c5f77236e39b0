// What several shapes need to answer what they are asked (shape.h).
#pragma once

#include <optional>
#include <string>

#include "math/box.h"
#include "math/frame.h"
#include "optics/shape.h"

namespace anamorph {

/// Of the mirror's size: flatter or nearer than this counts as nothing.
constexpr double shapeTolerance = 1e-6;
/// In radii: from farther away too few digits are left to say where on a round mirror a ray arrives.
constexpr double farthestEye = 1e6;

/// The side of a normal that faces a ray.
Direction facing(const Direction& normal, const Vector& ray);

/// Unit, out of a round mirror: the eye's own way `outwards`, unless it leads to the original's side.
Direction wayOut(const Vector& outwards, const Vector& fromOriginal, const Direction& otherwise);

/// The scene's axes turned by the shortest way that brings z to `axis`, which is unit.
Axes axesAlong(const Direction& axis);

/// The direction across an axis at a fraction of the way around it.
Direction around(const Direction& axis, double fraction);

/// The radius at the bottom of a round mirror that fills a room and is `narrowing` times as wide at its top: half as
/// far from the axis as the eye at most, which is outside of it, continued.
double fillingRadius(const ShapeExtent& room, const Point& eye, double narrowing = 1);

/// The box of two discs that face each other.
Box boxOfDiscs(const Point& a, double radiusA, const Point& b, double radiusB);

/// What is wrong with a radius; with a length that has a name.
std::optional<std::string> findRadiusProblem(double radius);
std::optional<std::string> findLengthProblem(const char* name, double length);

/// What is wrong with an eye at this distance from a thing whose radius, or whatever is named, is so large.
std::optional<std::string> findDistanceProblem(double distance, double size, const char* name = "radius");

/// What is wrong with an eye at this distance from a curved surface of this size: it is on it.
std::optional<std::string> findContactProblem(double gap, double size);

/// A direction at a point, of any length, as a map turns it: as long as before, and the very same when it is not turned.
Vector turnedBy(const ShapeMap& map, const Point& at, const Vector& way);

/// Whether a thing with this axis stands upright, and how the sheet says how it stands.
bool isUpright(const Vector& axis);
std::string stanceAlong(const Vector& axis);

}  // namespace anamorph
