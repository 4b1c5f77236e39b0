// The optic: what light passes on its way from the eye to the sculpture. An ordered list of parts, each a surface
// and what it does to light: a mirror reflects, a canvas lets light pass. Glass, or several mirrors, follow the
// same contract, because a path is a list of points and an exit ray.
//
//      E --------> Q0 (--> Q1 ...) = exit.origin --- exit.direction --->
//
// Where nothing bends the light the sculpture's points slide along the view rays, S = Q + k (P - Q) = E + s (P -
// E): for a small k they lie nearly in the canvas, which is perspective anamorphosis as on pavements (the thesis'
// figure 3). The canvas may be before or behind the original.
//
// Lengths along a path count in the length of the ray that was sent. A ray from the eye E towards a vertex P,
// sent with direction P - E, has gone the fraction `travelled` of |EP| when it leaves the optic; the target is
// at 1. No square root is needed for that, and what is left of the way, 1 - travelled, is what the
// sculpture's vertex is moved by.
//
// Anamorphosis (../anamorphosis) never asks what the optic is: what it needs to know a path tells.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "optics/shape.h"

namespace anamorph {

/// What a part does to light.
enum class OpticKind {
  mirror,
  canvas,  ///< lets it pass, and nothing stands there: a surface that is only thought of
};

struct OpticPart {
  OpticKind kind = OpticKind::mirror;
  Shape shape;
  bool operator==(const OpticPart&) const = default;
};

struct Optic {
  Optic() = default;
  Optic(OpticKind kind, Shape shape) : parts{{kind, std::move(shape)}} {}
  bool operator==(const Optic&) const = default;

  /// Of the first part, the one that is edited.
  const Shape& shape() const { return parts.front().shape; }
  Shape& shape() { return parts.front().shape; }

  std::vector<OpticPart> parts{1};  ///< in the order in which light passes them; one at least
};

/// Whether it is a thing that stands there, to be seen and built.
bool isVisible(const Optic& optic);

/// Whether pictures show it: it stands there, and its shapes are sound.
bool isShown(const Optic& optic);

/// What its surface is called in messages: "mirror", "canvas".
const char* surfaceName(const Optic& optic);

/// The first part's fault that has one (findShapeProblem), as a sentence that names the part; nothing when all are
/// sound.
std::optional<std::string> findProblem(const Optic& optic);

/// Why no anamorphosis can be made of a sound optic from this eye: the first part's reason that has one.
std::optional<std::string> findEyeProblem(const Optic& optic, const Point& eye);

/// Of its sound parts; empty when there is none.
Box boxOf(const Optic& optic);

/// Where a ray meets the optic.
struct OpticHit : SurfaceHit {
  std::size_t part = 0;
};

/// The nearest hit of all parts at t > tMin; nothing when the ray misses.
std::optional<OpticHit> intersect(const Optic& optic, const Ray& ray, double tMin = 0);

/// The same of those parts only that stand there: of canvases nothing is seen, and they are in no ray's way.
std::optional<OpticHit> intersectVisible(const Optic& optic, const Ray& ray, double tMin = 0);

/// What a part has done to a ray that met it.
struct Interaction {
  Vector direction{0};  ///< the ray's from there on, as long as before
  bool bends = false;   ///< whether the ray was changed at all
};
Interaction interact(const Optic& optic, const Ray& ray, const OpticHit& hit);

/// What became of a ray that was sent to a target point through the optic (method section 2).
enum class PathStatus : std::uint8_t {
  mapped,           ///< it leaves the optic and is free to go on
  missesMirror,     ///< it never meets the finite surface
  inFrontOfMirror,  ///< it reaches the target before the surface
  grazing,          ///< it touches the surface at less than one degree
  hitsMirrorAgain,  ///< after leaving it meets the surface again before its end
};
constexpr int pathStatusCount = 5;

/// The name in JSON: "mapped", "missesMirror", ...
const char* pathStatusName(PathStatus status);
/// What so many vertices do, for people: "miss the mirror".
const char* pathStatusWords(PathStatus status);

struct OpticPath {
  static constexpr int maxPoints = 12;

  std::array<Point, maxPoints> points;       ///< where it meets the optic, in order
  std::array<Direction, maxPoints> normals;  ///< unit, towards the incoming ray
  std::array<Vector, maxPoints> onward;      ///< the ray after each point, as long as the ray sent
  int pointCount = 0;                        ///< 0: it misses
  bool bends = false;                        ///< whether anything has changed its direction
  double travelled = 0;  ///< from the origin to the last point, in lengths of the ray sent
  double sine = 1;       ///< of the angle between ray and surface, the smallest of all points
  Ray exit;              ///< from the last point, as long as the ray sent; undefined for a miss
};

/// Follows a ray (direction of any length > 0) through the parts in their order.
OpticPath followRay(const Optic& optic, const Ray& ray);

/// The status of a path to a target at distance 1 (in lengths of the ray sent) when it goes `exitLength`
/// beyond the optic.
PathStatus statusOf(const Optic& optic, const OpticPath& path, double exitLength);

/// How far the exit ray goes before it meets the optic again, in its own length; infinite when it never does, or
/// when nothing has bent it.
double freeLength(const Optic& optic, const OpticPath& path);

/// The batch form of followRay, for rays from one eye (exit_kernel.h): writes, for each target, the point that lies
/// depthScale * (1 - travelled) along its exit ray. Returns how many are plain.
std::size_t exitPoints(const Optic& optic, const ExitBlock& block);

/// Whether exitPoints() finds any: else every ray has to be followed by itself, which takes ten times as long.
bool hasBatch(const Optic& optic);

/// How something behind the optic is seen along a ray from the eye.
struct LineOfSight {
  bool meets = false;  ///< whether the ray meets the optic at all
  bool ends = false;   ///< it is bent away, and there is no way on: nothing is seen behind the optic
  std::array<Point, OpticPath::maxPoints> bends;  ///< between the eye and `last`, where it was bent
  int bendCount = 0;
  Ray last;                                                 ///< on which things are seen
  double length = std::numeric_limits<double>::infinity();  ///< of `last` until it meets the optic again
};
/// Where nothing bends light, things are seen along the ray itself, whether it meets the canvas or not.
LineOfSight lineOfSight(const Optic& optic, const Ray& ray);

}  // namespace anamorph
