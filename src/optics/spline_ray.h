// What rays and surfaces of splines need of each other: a ray in the surface's own frame, counted from where it is
// nearest to it (so that the far beginning cancels nothing), the stretch of it that has to be looked at, and which of
// the crossings that its pieces find are the same one.
//
// Neighbouring pieces overlap by a little: a root on a knot is found by one of them at least, however both are rounded.
// Those that both find are told by this: a surface is crossed from one side and then from the other, so two crossings
// in the same direction at one place are one.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/ray.h"
#include "math/uniform_spline.h"
#include "optics/shape_helpers.h"

namespace anamorph {

/// Of a surface's size: by so much every piece reaches into its neighbours.
constexpr double pieceOverlap = 1e-12;

/// A ray in a frame: at t it is at `at` + (t - start) `direction`.
struct FrameRay {
  Point at;
  Vector direction;
  double start;

  Point after(double way) const { return at + way * direction; }
};

inline Vector inFrame(const Axes& axes, const Vector& v) {
  return {glm::dot(v, axes[0]), glm::dot(v, axes[1]), glm::dot(v, axes[2])};
}
inline Vector fromFrame(const Axes& axes, const Vector& v) {
  return v.x * axes[0] + v.y * axes[1] + v.z * axes[2];
}

/// Counted from where the ray is nearest to the frame's origin.
inline FrameRay rayInFrame(const Ray& ray, const Point& origin, const Axes& axes) {
  const Vector from = ray.origin - origin;
  const double start = -glm::dot(from, ray.direction) / lengthSquared(ray.direction);
  return {inFrame(axes, from + start * ray.direction), inFrame(axes, ray.direction), start};
}

/// A part of a ray, from one way to another.
struct Stretch {
  double from = -std::numeric_limits<double>::infinity();
  double to = std::numeric_limits<double>::infinity();

  bool empty() const { return !(from <= to); }
  Stretch countedFrom(double start) const { return {from - start, to - start}; }

  /// Keeps where `value` + way * `slope` is between two bounds.
  void keepBetween(double value, double slope, double low, double high) {
    if (slope == 0) {
      if (!(value >= low && value <= high)) to = -std::numeric_limits<double>::infinity();
      return;
    }
    const double one = (low - value) / slope, other = (high - value) / slope;
    from = std::max(from, std::min(one, other));
    to = std::min(to, std::max(one, other));
  }
};

/// Tells crossings apart that come in order.
class CrossingFilter {
 public:
  /// Of the same crossing, two pieces say places that are no farther apart than this.
  explicit CrossingFilter(double sameWithin) : sameWithin_(sameWithin) {}

  bool isNew(double at, bool rising) {
    const bool same = rising == rising_ && at - at_ <= sameWithin_;
    at_ = at;
    rising_ = rising;
    return !same;
  }

 private:
  double sameWithin_;
  double at_ = -std::numeric_limits<double>::infinity();
  bool rising_ = false;
};

/// Unit, against the ray.
inline SurfaceHit hitAt(const Ray& ray, double t, const Axes& axes, const Vector& normalInFrame) {
  return {t, ray.at(t), facing(fromFrame(axes, glm::normalize(normalInFrame)), ray.direction)};
}

}  // namespace anamorph
