// The optic: what light passes on its way from the eye to the sculpture. A mirror of some shape, or no mirror
// at all: then the surface is a canvas that light passes straight through. Glass, or several bounces, would
// follow the same contract, because a path is a list of points and an exit ray.
//
//      E --------> Q0 (--> Q1 ...) = exit.origin --- exit.direction --->
//
// Without a mirror the sculpture's points slide along the view rays, S = Q + k (P - Q) = E + s (P - E): for a
// small k they lie nearly in the canvas, which is perspective anamorphosis as on pavements (the thesis'
// figure 3). The canvas may be before or behind the original.
//
// Lengths along a path count in the length of the ray that was sent. A ray from the eye E towards a vertex P,
// sent with direction P - E, has gone the share `travelled` of |EP| when it leaves the optic; the target is
// at 1. No square root is needed for that, and what is left of the way, 1 - travelled, is what the
// sculpture's vertex is moved by.
//
// Anamorphosis (../anamorphosis) knows only this file and exit_points.h: it never asks what the optic is.
#pragma once

#include <array>
#include <cstdint>

#include "optics/mirror_shapes.h"

namespace anamorph {

enum class OpticKind {
  mirror,
  none,  ///< no mirror: the shape is a canvas that nothing is reflected by
};

struct Optic {
  OpticKind kind = OpticKind::mirror;
  MirrorShape shape;
  bool operator==(const Optic&) const = default;
};

/// What became of a ray that was sent to a target point through the optic (method section 2).
enum class PathStatus : std::uint8_t {
  mapped,           ///< it leaves the optic and is free to go on
  missesMirror,     ///< it never meets the finite surface
  inFrontOfMirror,  ///< it reaches the target before the surface
  grazing,          ///< it touches the surface at less than one degree
  hitsMirrorAgain,  ///< after leaving it meets the surface again before its end
};
constexpr int pathStatusCount = 5;

/// The name in JSON and messages: "mapped", "missesMirror", ...
const char* pathStatusName(PathStatus status);

/// sin(1 degree): a ray flatter than this grazes.
constexpr double grazingSine = 0.017452406437283512;

struct OpticPath {
  static constexpr int maxPoints = 4;

  std::array<Point, maxPoints> points{};       ///< where it meets the optic, in order
  std::array<Direction, maxPoints> normals{};  ///< unit, towards the incoming ray
  int pointCount = 0;                          ///< 0: it misses
  double travelled = 0;  ///< from the origin to the last point, in lengths of the ray sent
  double sine = 1;       ///< of the angle between ray and surface, the smallest of all points
  Ray exit;              ///< from the last point, as long as the ray sent; undefined for a miss
};

/// What its surface is called in messages: "mirror", "canvas".
const char* surfaceName(const Optic& optic);

/// Follows a ray (direction of any length > 0) through the optic.
OpticPath followRay(const Optic& optic, const Ray& ray);

/// The status of a path to a target at distance 1 (in lengths of the ray sent) when it goes `exitLength`
/// beyond the optic.
PathStatus statusOf(const Optic& optic, const OpticPath& path, double exitLength);

/// How far the exit ray goes before it meets the optic again, in its own length; infinite when it never does.
double freeLength(const Optic& optic, const OpticPath& path);

/// Whether the image is mirrored, so that triangles have to be turned around: true for one reflection.
bool reversesHandedness(const Optic& optic);

}  // namespace anamorph
