// Both sides of every curved mirror against a slow search that shares nothing with the program (surface_of.h): all
// crossings in order, what becomes of rays inside a hollow mirror, and which eyes see the outside only.

#include <gtest/gtest.h>

#include "optics/optic.h"
#include "optics/reflect.h"
#include "random_scene.h"
#include "surface_of.h"

namespace anamorph {
namespace {

using namespace testing;

constexpr unsigned scenes = 1000;

template <typename Body>
void forCurved(const Body& body) {
  for (const ShapeKind kind : curvedShapeKinds) {
    for (unsigned seed = 0; seed < scenes; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      body(kind, random);
      if (::testing::Test::HasFatalFailure()) return;
    }
  }
}

// Too near a border or a tangent for a slow search to tell.
bool isUnclear(const SurfaceOf& surface, const Ray& ray, double t) {
  const Point p = ray.at(t);
  const double steep = std::abs(glm::dot(surface.normalAt(p), glm::normalize(ray.direction)));
  return std::abs(surface.within(p)) < 1e-6 || steep < 0.1;
}

TEST(BothSides, EveryCrossingIsMetInOrder) {
  std::size_t met = 0, twice = 0, unclear = 0;
  forCurved([&](ShapeKind kind, Random& random) {
    const Shape shape = makeRandomScene(kind, random).optic.shape();
    const SurfaceOf surface = surfaceOf(shape);
    const Box box = boxOf(shape);
    const Point from = box.centre() + random.uniform(0, 1.5) * box.diagonal() * random.direction();
    const Ray ray{from, random.uniform(0.5, 2) * (box.centre() + 0.4 * box.size() * random.point(1) - from)};
    const double end = 4 * box.diagonal() / glm::length(ray.direction);
    std::size_t here = 0;
    double last = 0;
    for (const double t : crossingsOf(surface, ray, 0, end)) {
      if (isUnclear(surface, ray, t)) {
        ++unclear;
        return;
      }
      if (surface.within(ray.at(t)) < 0) continue;
      const auto hit = intersect(shape, ray, last);
      ASSERT_TRUE(hit) << "at " << t;
      EXPECT_NEAR(hit->t, t, 1e-9);
      EXPECT_GT(std::abs(glm::dot(hit->normal, surface.normalAt(hit->point))), 1 - 1e-6);
      EXPECT_LE(glm::dot(hit->normal, ray.direction), 0);
      last = hit->t * (1 + 1e-12);
      ++here;
    }
    const auto beyond = intersect(shape, ray, last);
    if (beyond && isUnclear(surface, ray, beyond->t)) {
      ++unclear;
      return;
    }
    EXPECT_FALSE(beyond && beyond->t < end) << "at " << beyond->t;
    met += here > 0;
    twice += here > 1;
  });
  EXPECT_GT(met, 2.5 * scenes);
  EXPECT_GT(twice, 0.5 * scenes);
  EXPECT_LT(unclear, scenes);
}

TEST(BothSides, RaysWithinAHollowMirrorEndWhereTheyMeetItAgain) {
  std::size_t again = 0, free = 0;
  forCurved([&](ShapeKind kind, Random& random) {
    const RandomScene scene = makeHollowScene(kind, random);
    EXPECT_FALSE(findEyeProblem(scene.optic, scene.eye));
    const SurfaceOf surface = surfaceOf(scene.optic.shape());
    const Point p = makeRandomOriginal(scene, random);
    const OpticPath path = followRay(scene.optic, {scene.eye, p - scene.eye});
    ASSERT_EQ(path.pointCount, 1);
    ASSERT_LT(glm::length(path.points[0] - scene.onMirror), 1e-11);
    const double exitLength = random.uniform(0.1, 3) * (1 - path.travelled);

    const Ray onward{scene.onMirror, reflect(p - scene.eye, surface.normalAt(scene.onMirror))};
    EXPECT_LT(glm::length(onward.direction - path.exit.direction), 1e-6 * glm::length(onward.direction));
    bool meets = false;
    for (const double t : crossingsOf(surface, onward, 1e-4 * exitLength, exitLength)) {
      if (isUnclear(surface, onward, t)) return;
      meets |= surface.within(onward.at(t)) > 0;
    }
    const auto nearEnd = crossingsOf(surface, onward, 0.999 * exitLength, 1.001 * exitLength);
    if (!nearEnd.empty()) return;
    EXPECT_EQ(statusOf(scene.optic, path, exitLength),
              meets ? PathStatus::hitsMirrorAgain : PathStatus::mapped);
    ++(meets ? again : free);
  });
  EXPECT_GT(again, scenes);
  EXPECT_GT(free, scenes);
}

TEST(BothSides, WhoSeesTheConvexSideSeesNothingElse) {
  std::size_t convex = 0, hollow = 0;
  forCurved([&](ShapeKind kind, Random& random) {
    const Shape shape = makeRandomScene(kind, random).optic.shape();
    const SurfaceOf surface = surfaceOf(shape);
    const Box box = boxOf(shape);
    const Point eye = box.centre() + random.uniform(0, 1.5) * box.diagonal() * random.direction();
    if (!seesConvexSide(shape, eye)) {
      ++hollow;
      return;
    }
    ++convex;
    EXPECT_GT(surface.value(eye), 0);
    for (int i = 0; i < 100; ++i) {
      const double v = i % 3 == 0 ? 0.001 : i % 3 == 1 ? 0.999 : random.uniform(0, 1);  // often near a border
      const Point aim = pointAt(shape, random.uniform(0, 1), v);
      const auto hit = intersect(shape, {eye, aim - eye});
      if (!hit || glm::dot(hit->normal, glm::normalize(aim - eye)) > -1e-3) continue;
      EXPECT_GT(glm::dot(hit->normal, surface.normalAt(hit->point)), 0) << "the inner wall";
    }
  });
  EXPECT_GT(convex, scenes);
  EXPECT_GT(hollow, scenes);
}

TEST(BothSides, ConvexIsToldFromHollow) {
  const CylinderMirror tube{{0, 0, 0}, {0, 0, 2}, 1};
  const ConeMirror cut{{0, 0, 0}, {0, 0, 2}, 2, 1}, pointed{{0, 0, 0}, {0, 0, 4}, 2, 0};
  const SphereMirror ball{{0, 0, 0}, 1};
  const EllipsoidMirror egg{{0, 0, 0}, {1, 2, 3}, {0, 0, 0}};
  const ParaboloidMirror bowl{{0, 0, 0}, {0, 0, 1}, 0.5, 1, 0}, ring{{0, 0, 0}, {0, 0, 1}, 0.5, 1, 0.5};
  Shape half = ball;
  half.clipBy({{{0, 0, 0}, {0, 0, -1}}});
  const struct {
    const char* what;
    Shape shape;
    Point eye;
    bool convex;
  } table[] = {
      {"plane", PlaneMirror{}, {0, -3, 0}, true},
      {"beside a tube", tube, {0, -3, 1.9}, true},
      {"over a tube", tube, {0, -3, 2.1}, false},
      {"in a tube", tube, {0, -0.5, 1}, false},
      {"beside a cone", cut, {0, -3, 1}, true},
      {"over a cone", cut, {0, -3, 2.1}, false},
      {"into a cone's top, steeper than its wall", cut, {0, 0.5, 6}, true},
      {"under a cone", cut, {0, -3, -0.1}, false},
      {"over a cone's point", pointed, {0, -3, 9}, true},
      {"on a pointed cone's axis", pointed, {0, 0, 9}, true},
      {"in a cone", pointed, {0, 0, 1}, false},
      {"before a ball", ball, {0, -1.1, 0}, true},
      {"in a ball", ball, {0, -0.9, 0}, false},
      {"before half a ball", half, {0, -3, 1}, false},
      {"before an ellipsoid", egg, {1.1, 0, 0}, true},
      {"in an ellipsoid", egg, {0, 0, 2.9}, false},
      {"behind a bowl", bowl, {0, 0.1, -1}, true},
      {"beside a bowl", bowl, {0, 3, 0.49}, true},
      {"over a bowl's rim", bowl, {0, 3, 0.51}, false},
      {"in a bowl", bowl, {0, 0, 0.4}, false},
      {"through a bowl's hole", ring, {0, 0.1, -1}, false},
      {"beside a bowl with a hole", ring, {0, 3, 0.2}, true},
  };
  for (const auto& row : table) EXPECT_EQ(seesConvexSide(row.shape, row.eye), row.convex) << row.what;
}

}  // namespace
}  // namespace anamorph
