#include "anamorphosis/caustic.h"

#include <gtest/gtest.h>

#include "anamorphosis/ray_bundle.h"
#include "geometry/shapes.h"
#include "random_scene.h"

namespace anamorph {
namespace {

PointArray boxBehind(const Point& at) {
  return mapPoints(makeBox({6, 2, 2}, 4).positions, [&](const Point& p) { return at + p; });
}

TEST(Caustic, IsNoneBeyondWhatBulges) {
  VertexMap map;
  map.optic.shape() = SphereMirror{{0, 0, 4}, 4};
  map.eye = {0, -9.9, 15.9};
  EXPECT_TRUE(findCaustic(map, boxBehind({0, 5.2, 1.7}), 100).empty());
}

TEST(Caustic, HasBothFocalPointsOfEveryRay) {
  VertexMap map;
  map.optic.shape() = SphereMirror{{0, -12, 4}, 14};
  map.eye = {0, -10.7, 8};
  const PointArray box = boxBehind({0, 5.9, 1.6});
  const std::vector<CausticPoint> points = findCaustic(map, box, 50, 1e9);
  EXPECT_EQ(points.size(), 100u);
  for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
    EXPECT_FALSE(points[i].second);
    EXPECT_TRUE(points[i + 1].second);
    const auto ray = exitRayTowards(map, box[i / 2 * box.size() / 50]);
    ASSERT_TRUE(ray);
    for (const std::size_t k : {i, i + 1}) {
      const Vector way = points[k].at - ray->exit;
      EXPECT_LT(glm::length(glm::cross(way, ray->onward)), 1e-9) << "on the ray";
      EXPECT_GT(glm::dot(way, ray->onward), 0);
    }
  }
  EXPECT_LT(findCaustic(map, box, 50, 1).size(), 100u) << "not what is far beyond the sculpture";
}

// The inside of a whole ball: what is beyond the opposite wall no ray reaches.
TEST(Caustic, EndsWhereTheMirrorIsMetAgain) {
  VertexMap map;
  map.optic.shape() = SphereMirror{{0, 0, 0}, 4};
  map.eye = {0.5, -3, 0.2};
  const PointArray box = boxBehind({0, 6, 0});
  int points = 0;
  for (const CausticPoint& point : findCaustic(map, box, 200, 1e9)) {
    ++points;
    EXPECT_LT(glm::length(point.at), 4);
  }
  EXPECT_GT(points, 50);
}

}  // namespace
}  // namespace anamorph
