// What the scene stands on: a disk of the plane z = height that is seen from above only. It hides what is below it, in
// pictures and for the match alike.
#pragma once

#include <limits>
#include <optional>

#include "math/ray.h"

namespace anamorph {

struct Floor {
  double height = 0;
  Point centre{0};  ///< of the disk; its z does not count
  double reach = std::numeric_limits<double>::infinity();

  bool operator==(const Floor&) const = default;
};

/// Where a ray meets it, nearer than tMax, in lengths of its direction; nothing when it does not.
inline std::optional<double> intersect(const Floor& floor, const Ray& ray, double tMax) {
  const double above = ray.origin.z - floor.height;
  if (!(above > 0) || !(ray.direction.z < 0)) return std::nullopt;
  const double t = above / -ray.direction.z;
  if (!(t < tMax)) return std::nullopt;
  const Vector away = ray.at(t) - floor.centre;
  if (!(away.x * away.x + away.y * away.y < floor.reach * floor.reach)) return std::nullopt;
  return t;
}

}  // namespace anamorph
