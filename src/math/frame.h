// Orthonormal frames: three perpendicular directions at a point.
#pragma once

#include "math/vec.h"

namespace anamorph {

/// right x up = -forward: seen along `forward`, x goes right and y goes up.
struct Frame {
  Direction right{1, 0, 0};
  Direction up{0, 1, 0};
  Direction forward{0, 0, -1};

  bool operator==(const Frame&) const = default;
};

/// A direction perpendicular to `d`, chosen so that it depends smoothly on d almost everywhere.
Direction perpendicular(const Direction& d);

/// The frame that looks along `forward` with `up` as nearly up as can be. When `up` is parallel to `forward` another
/// up is taken: the result is always orthonormal.
Frame makeFrame(const Direction& forward, const Direction& up);

}  // namespace anamorph
