// Where neighbouring rays cross beyond a hollow mirror (method-optics, fact G8), and that the sign of the spread changes
// there and nowhere else.

#include "anamorphosis/ray_bundle.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

// Of a bundle from a point at distance s, in the plane of incidence and across it (Coddington).
std::vector<double> coddington(double radius, double cosine, double s) {
  std::vector<double> foci;
  for (const double f : {1 / (2 / (radius * cosine) - 1 / s), 1 / (2 * cosine / radius - 1 / s)}) {
    if (f > 0) foci.push_back(f);
  }
  std::sort(foci.begin(), foci.end());
  return foci;
}

// A whole ball, seen from inside.
struct HollowBall {
  explicit HollowBall(Random& random) : radius(random.uniform(1, 20)), centre(random.point(10)) {
    map.optic.shape() = SphereMirror{centre, radius};
    map.eye = centre + random.uniform(0.05, 0.95) * radius * random.direction();
    direction = random.direction();
  }
  double radius;
  Point centre;
  VertexMap map;
  Direction direction;
};

TEST(RayBundle, OfAHollowBallCrossesWhereCoddingtonSays) {
  int crossings = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const HollowBall ball(random);
    const auto ray = exitRayTowards(ball.map, ball.map.eye + ball.direction);
    ASSERT_TRUE(ray);
    const double s = glm::length(ray->exit - ball.map.eye);
    const double cosine = glm::dot(ray->exit - ball.centre, ball.direction) / ball.radius;
    if (cosine < 0.2) continue;
    const auto bundle = bundleAround(ball.map, ball.map.eye + ball.direction);
    ASSERT_TRUE(bundle);
    const std::vector<double> expected = coddington(ball.radius, cosine, s), found = bundle->foci();
    const bool nearlyParallel =
        std::any_of(expected.begin(), expected.end(), [&](double f) { return f > 1e3 * s; });
    if (nearlyParallel) continue;
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double tolerance =
          found.size() == 2 && expected[1] - expected[0] < 1e-3 * expected[1] ? 1e-3 : 1e-6;
      EXPECT_NEAR(found[i], expected[i], tolerance * expected[i]);
      ++crossings;
    }
    // Before, between and beyond. The mirror itself exchanges left and right.
    double sign = -1, from = 0;
    for (const double focus : expected) {
      if (focus - from > 0.01 * focus) {
        EXPECT_GT(sign * bundle->spread(0.5 * (from + focus)), 0);
      }
      sign = -sign;
      from = focus;
    }
    EXPECT_GT(sign * bundle->spread(2 * from + s), 0);
  }
  EXPECT_GT(crossings, 1000);
}

TEST(RayBundle, NeverCrossesBeyondWhatBulges) {
  for (const auto kind : testing::allShapeKinds) {
    for (unsigned seed = 0; seed < 300; ++seed) {
      SCOPED_TRACE(std::to_string(int(kind)) + " seed " + std::to_string(seed));
      Random random(seed);
      const testing::RandomScene scene = makeRandomScene(kind, random);
      VertexMap map;
      map.optic = scene.optic;
      map.eye = scene.eye;
      const auto bundle = bundleAround(map, scene.onMirror);
      if (!bundle) continue;  // at the border
      EXPECT_TRUE(bundle->foci().empty()) << bundle->foci().front();
      for (const double distance : {0.0, 0.1, 10.0, 1e4})
        EXPECT_LT(bundle->spread(distance), 0) << "as the mirror itself turns it";
    }
  }
}

}  // namespace
}  // namespace anamorph
