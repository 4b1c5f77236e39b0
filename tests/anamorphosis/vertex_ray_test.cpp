#include "anamorphosis/vertex_ray.h"

#include <gtest/gtest.h>

#include "random_scene.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

TEST(VertexRay, HasALegForEveryPart) {
  const VertexMap map{makePeriscope(), {0, -5, 0}, 0.5, {}};
  for (unsigned seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Point p = Point(0, 20, 0) + random.point(0.5);
    const VertexRay ray = makeVertexRay(map, p);
    ASSERT_TRUE(ray.mapped());
    ASSERT_EQ(ray.legs.size(), 2u);
    EXPECT_LT(glm::length(ray.legs[0].start +
                          glm::length(ray.legs[1].start - ray.legs[0].start) * ray.legs[0].direction -
                          ray.legs[1].start),
              1e-12);
    for (const VertexLeg& leg : ray.legs) EXPECT_NEAR(leg.angleInDegrees, leg.angleOutDegrees, 1e-5);
    // The way to P is unfolded: what is left of it after both mirrors, times k.
    double way = glm::length(p - ray.eye);
    way -= glm::length(ray.legs[0].start - ray.eye) + glm::length(ray.legs[1].start - ray.legs[0].start);
    EXPECT_NEAR(ray.distance, way, 1e-12);
    EXPECT_LT(glm::length(ray.sculpture - ray.legs[1].start - 0.5 * way * ray.legs[1].direction), 1e-12);
    EXPECT_LT(glm::length(mapPoint(map, p).point - ray.sculpture), 1e-12);
  }
}

TEST(VertexRay, WithoutAnyHasNoLegs) {
  const VertexRay ray = makeVertexRay({makePeriscope(), {0, -5, 0}, 1, {}}, {0, 20, 40});
  EXPECT_FALSE(ray.meets());
  EXPECT_EQ(ray.status, PathStatus::missesMirror);
}

}  // namespace
}  // namespace anamorph
