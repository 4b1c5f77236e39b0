#include "edit/camera_body.h"

#include <gtest/gtest.h>

#include "optics/camera.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

TEST(CameraBody, IsHitWhereItIs) {
  int hits = 0, misses = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Camera camera;
    camera.eye = random.point(10);
    camera.target = camera.eye + random.direction();
    const double size = random.uniform(0.1, 2);
    const Frame frame = Projection(camera, 1, 1).frame();
    const Vector axes[] = {frame.right, frame.up, frame.forward};
    // A point of the body, seen from outside.
    const Point inUnits =
        rtCameraBody.min +
        Vector(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)) * rtCameraBody.size();
    const Point from = camera.eye + 20.0 * random.direction();
    const auto placed = [&](const Point& p) {
      return camera.eye + size * (p.x * axes[0] + p.y * axes[1] + p.z * axes[2]);
    };
    const Ray ray{from, placed(inUnits) - from};
    const auto t = intersectRtCamera(camera, size, ray);
    ASSERT_TRUE(t);
    EXPECT_GT(*t, 0);
    EXPECT_LE(*t, 1 + 1e-9);
    ++hits;
    if (!intersectRtCamera(camera, size, {from, from - placed(inUnits)})) ++misses;
    EXPECT_FALSE(intersectRtCamera(camera, size, {placed(inUnits), ray.direction})) << "from inside";
  }
  EXPECT_EQ(hits, 2000);
  EXPECT_EQ(misses, 2000);
}

}  // namespace
}  // namespace anamorph
