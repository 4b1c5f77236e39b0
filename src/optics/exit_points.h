// Many rays through the optic at once: the batch form of followRay for rays from one eye to many targets. The
// work is done in blocks that stay in the first-level cache, on separate arrays, without branches, so that it
// vectorises.
//
// Only the plain case is decided here: one bounce, the target behind the mirror, not grazing, and no second
// bounce possible. For every other target `plain` is 0 and followRay has to be asked; where it is 1, both
// agree to the bit.
#pragma once

#include <cstddef>
#include <cstdint>

#include "optics/optic.h"

namespace anamorph {

/// Coordinates of the same points, in separate arrays.
template <typename Number>
struct PointPointers {
  Number* x;
  Number* y;
  Number* z;
};

constexpr std::size_t exitBlockSize = 256;

/// Sends rays from `eye` to `count` <= exitBlockSize targets and writes, for each, the point that lies
/// depthScale * (1 - travelled) along its exit ray (OpticPath). Returns how many are plain; plain[i] is 1 or
/// 0, and where it is 0 the point is unspecified. `points` must not overlap `targets`.
std::size_t exitPoints(const Optic& optic, const Point& eye, double depthScale,
                       PointPointers<const double> targets, std::size_t count, PointPointers<double> points,
                       std::int64_t* plain);

}  // namespace anamorph
