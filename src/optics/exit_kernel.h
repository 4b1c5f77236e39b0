// Many rays through a mirror at once: the loop that all shapes share. A shape brings its bounce, which tells
// where the ray E + t V meets the surface; the rest is the same for all. Blocks stay in the first-level cache, on
// separate arrays, without branches, so that it vectorises.
//
// Only the plain case is decided here: one bounce, the target behind the mirror, not grazing, and no second bounce
// before the ray's end: outside a convex surface there is none, in a hollow one the bounce tells (isFree). For every
// other target `plain` is 0 and followRay (optic.h) has to be asked; where it is 1, both agree to the bit.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "base/target_clones.h"
#include "math/vec.h"

namespace anamorph {

/// Coordinates of the same points, in separate arrays.
template <typename Number>
struct PointPointers {
  Number* x;
  Number* y;
  Number* z;
};

constexpr std::size_t exitBlockSize = 256;

/// sin(1 degree): a ray flatter than this grazes.
constexpr double grazingSine = 0.017452406437283512;

/// Targets of rays from one eye, and where their results go; `points` must not overlap `targets`.
struct ExitBlock {
  Point eye;
  double depthScale;
  double depthOffset;
  PointPointers<const double> targets;
  std::size_t count;  ///< at most exitBlockSize
  PointPointers<double> points;
  std::int64_t* plain;  ///< 1 or 0; where it is 0 the point is unspecified
};

/// What a bounce answers for one ray.
struct BouncePoint {
  double t;
  Vector normal;   ///< unit, towards either side
  bool onSurface;  ///< and the plain case as far as the shape can tell
};

/// As `condition ? yes : no`, bit by bit: of that, the compiler makes conditions between conditions when the result is
/// compared later, and does not vectorise them.
[[gnu::always_inline]] inline double select(bool condition, double yes, double no) {
  const std::int64_t mask = -std::int64_t(condition);
  return std::bit_cast<double>((std::bit_cast<std::int64_t>(yes) & mask) |
                               (std::bit_cast<std::int64_t>(no) & ~mask));
}

/// The first root of a t^2 + 2 b t + c when the eye is outside (c > 0) and the ray comes nearer, with the same bits as
/// solveQuadratic's; else a t that is not > 0. A number alone: a struct would keep the loop from vectorising.
[[gnu::always_inline]] inline double firstFromOutside(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  const bool valid = (discriminant >= 0) & (b < 0) & (c > 0);
  const double t = c / (std::sqrt(std::abs(discriminant)) - b);  // abs: no branch
  return select(valid, t, -1);
}

/// Both roots of a t^2 + 2 b t + c in ascending order, with the bits of solveQuadratic and solveAnyQuadratic.
struct RootPair {
  double near, far;
  bool real;  ///< and both of them finite
};
[[gnu::always_inline]] inline RootPair bothRoots(double a, double b, double c) {
  const double discriminant = b * b - a * c;
  const double q = -(b + std::copysign(std::sqrt(std::abs(discriminant)), b));  // abs: no branch
  const double one = q / a, other = c / q;
  const bool real = (discriminant >= 0) & (a != 0) & (q != 0);
  return {one < other ? one : other, one < other ? other : one, real};
}

/// The other root where c = 0, for a ray that starts on a quadric: where it meets it again. Whether that is on its way
/// of this length; what is near the end counts, so that rounding never lets a ray pass.
[[gnu::always_inline]] inline bool isOnTheWay(double again, double length) {
  return (again > 0) & (again <= length * (1 + 1e-6));
}

/// How many are plain. That no array overlaps another has to be said at the parameters of the very function that
/// holds the loop; only what is forced inline gets the clone's instruction set, so a bounce is a struct with a
/// forced operator().
template <bool hasOffset, typename Bounce>
ANAMORPH_TARGET_CLONES std::size_t followArrays(const Bounce& sharedBounce, const Point& sharedEye,
                                                double depthScale, double depthOffset,
                                                const double* __restrict px, const double* __restrict py,
                                                const double* __restrict pz, std::size_t count,
                                                double* __restrict sx, double* __restrict sy,
                                                double* __restrict sz, std::int64_t* __restrict plain) {
  constexpr double steepSquared = grazingSine * grazingSine * (1 + 1e-6);  // what is near it is not plain
  const Bounce bounce = sharedBounce;  // copies that nothing written below can change
  const Point eye = sharedEye;
  std::int64_t plainCount = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Vector v = Point(px[i], py[i], pz[i]) - eye;
    const BouncePoint hit = bounce(eye, v);
    const double across = glm::dot(v, hit.normal);
    const Vector reflected = v - 2 * across * hit.normal;
    double length = depthScale * (1 - hit.t);
    if constexpr (hasOffset) length = length + depthOffset / std::sqrt(glm::dot(v, v));
    bool isFree = true;
    if constexpr (requires { bounce.isFree(hit.t, v, reflected, length); }) {
      isFree = bounce.isFree(hit.t, v, reflected, length);
    }
    const Point s = (eye + hit.t * v) + length * reflected;
    sx[i] = s.x;
    sy[i] = s.y;
    sz[i] = s.z;
    const bool steep = across * across > steepSquared * glm::dot(v, v);
    const std::int64_t isPlain = hit.onSurface & (hit.t > 0) & (hit.t <= 1) & steep & isFree;
    plain[i] = isPlain;
    plainCount += isPlain;
  }
  return static_cast<std::size_t>(plainCount);
}

template <typename Bounce>
std::size_t followBlock(const Bounce& bounce, const ExitBlock& b) {
  const auto follow = b.depthOffset == 0 ? followArrays<false, Bounce> : followArrays<true, Bounce>;
  return follow(bounce, b.eye, b.depthScale, b.depthOffset, b.targets.x, b.targets.y, b.targets.z, b.count,
                b.points.x, b.points.y, b.points.z, b.plain);
}

inline std::size_t followNone(const ExitBlock& b) {
  std::fill(b.plain, b.plain + b.count, 0);
  return 0;
}

}  // namespace anamorph
