#include "optics/camera.h"

#include <gtest/gtest.h>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

TEST(Projection, ImageAxesGoRightAndDown) {
  Camera camera;
  camera.eye = {0, -10, 0};
  camera.target = {0, 0, 0};
  camera.fovDegrees = 90;
  const Projection projection(camera, 200, 100);
  EXPECT_EQ(projection.pixelOf({0, 0, 0}), Pixel(100, 50));
  const auto corner = projection.pixelOf({20, 0, 10});  // right and up at 90 degrees, twice as wide as high
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->x, 200, 1e-9);
  EXPECT_NEAR(corner->y, 0, 1e-9);
  EXPECT_FALSE(projection.pixelOf({0, -11, 0})) << "behind the eye";
}

TEST(Projection, RayThroughAPixelIsSeenAtThatPixel) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Camera camera;
    camera.eye = random.point(10);
    camera.target = random.point(10);
    camera.up = random.direction();
    camera.fovDegrees = random.uniform(10, 120);
    const Projection projection(camera, random.integer(1, 800), random.integer(1, 800));
    const Pixel pixel(random.uniform(0, projection.width()), random.uniform(0, projection.height()));
    const Ray ray = projection.rayThrough(pixel);
    EXPECT_NEAR(glm::length(ray.direction), 1, 1e-14);
    const auto seen = projection.pixelOf(ray.at(random.uniform(0.1, 100)));
    ASSERT_TRUE(seen);
    EXPECT_LT(glm::length(*seen - pixel), 1e-9);
  }
}

TEST(Projection, DegenerateCamerasStillLookSomewhere) {
  Camera camera;
  camera.target = camera.eye;
  camera.up = Direction(0);
  const Projection atItself(camera, 4, 4);
  EXPECT_TRUE(isFinite(atItself.rayThrough({0, 0}).direction));
  camera.target = camera.eye + Vector(0, 0, -3);
  camera.up = {0, 0, 1};
  const Projection down(camera, 4, 4);
  EXPECT_TRUE(isFinite(down.rayThrough({0, 0}).direction));
}

}  // namespace
}  // namespace anamorph
