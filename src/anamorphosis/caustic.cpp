#include "anamorphosis/caustic.h"

#include <algorithm>

#include "anamorphosis/ray_bundle.h"

namespace anamorph {

std::vector<CausticPoint> findCaustic(const VertexMap& map, const PointArray& original, std::size_t count,
                                      double farthest) {
  std::vector<CausticPoint> points;
  const std::size_t asked = std::min(count, original.size());
  for (std::size_t i = 0; i < asked; ++i) {
    const Point& target = original[i * original.size() / asked];
    const Vector towards = target - map.eye;
    const auto ray = exitRayTowards(map, target);
    const auto bundle = ray ? bundleAround(map, *ray, target) : std::nullopt;
    if (!bundle) continue;
    const OpticPath path = followRay(map.optic, {map.eye, towards});
    bool second = false;
    for (const double focus : bundle->foci()) {
      if (focus > farthest * ray->distance) break;
      if (statusOf(map.optic, path, focus / glm::length(towards)) != PathStatus::mapped) break;
      points.push_back({ray->exit + focus * ray->onward, second});
      second = true;
    }
  }
  return points;
}

}  // namespace anamorph
