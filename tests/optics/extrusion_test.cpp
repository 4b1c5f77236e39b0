#include "optics/extrusion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "optics/plane.h"
#include "optics/random_splines.h"

namespace anamorph {
namespace {

using namespace testing;

// Fact G7: points in a line, equally far apart.
TEST(Extrusion, OfPointsInALineIsThePlane) {
  int hits = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    ExtrusionMirror wall;
    wall.origin = random.point(3);
    wall.axis = random.direction();
    wall.across = random.direction();
    wall.height = random.uniform(2, 6);
    const CurvePoint start(random.uniform(-3, 3), random.uniform(-3, 3));
    const CurvePoint step(random.uniform(0.2, 1), random.uniform(-1, 1));
    const int spans = random.integer(1, 9);
    wall.points.clear();
    for (int i = -1; i <= spans + 1; ++i) wall.points.push_back(start + double(i) * step);
    const Axes f = wall.axes();
    const auto at = [&](double u, double z) {
      const CurvePoint p = start + u * step;
      return wall.origin + p.x * f[0] + p.y * f[1] + z * f[2];
    };
    const PlaneMirror plane{{at(0, 0), at(spans, 0), at(spans, wall.height), at(0, wall.height)}};
    const Point eye = random.uniform(8, 30) * random.direction();
    const Ray ray{eye, plane.middle() + random.point(3) - eye};
    const auto a = intersect(Shape(wall), ray), b = intersect(plane, ray);
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) continue;
    ++hits;
    EXPECT_NEAR(a->t, b->t, 1e-11 / std::abs(glm::dot(b->normal, glm::normalize(ray.direction))));
    EXPECT_LT(glm::length(a->normal - b->normal), 1e-12);
  }
  EXPECT_GT(hits, 400);
}

// A wave that is its own mirror image: rays in the middle meet it exactly on a knot or in the middle of a span.
TEST(Extrusion, IsMetWhereItIsSymmetric) {
  for (const int count : {7, 8}) {
    ExtrusionMirror wall;
    wall.points.clear();
    for (int i = 0; i < count; ++i)
      wall.points.emplace_back(2 * i - count + 1, 0.3 * std::cos(2 * i - count + 1));
    for (const double x : {0.0, 1.0, -1.0, 2.0}) {
      for (const Vector& along : {Vector(0, 1, 0), Vector(0, 1, -0.25)}) {
        const Ray ray{{x, -9, 4}, along};
        const auto hit = intersect(Shape(wall), ray);
        ASSERT_TRUE(hit) << count << ", " << x;
        EXPECT_NEAR(hit->point.x, x, 1e-14);
        EXPECT_FALSE(intersect(Shape(wall), ray, hit->t)) << "met once";
      }
    }
  }
}

TEST(Extrusion, OfAClosedCurveIsAPillar) {
  ExtrusionMirror pillar;
  pillar.height = 5;
  pillar.closed = true;
  pillar.points.clear();
  for (int i = 0; i < 12; ++i) pillar.points.emplace_back(2 * std::cos(pi * i / 6), 2 * std::sin(pi * i / 6));
  EXPECT_EQ(findShapeProblem(pillar), std::nullopt);
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double angle = 2 * pi * i / 2000;
    const Direction out(std::cos(angle), std::sin(angle), 0);
    const Ray ray{9.0 * out + Point(0, 0, 1), -out};
    const auto near = intersect(Shape(pillar), ray);
    ASSERT_TRUE(near);
    EXPECT_NEAR(glm::length(CurvePoint(near->point)), 1.91, 0.02);
    EXPECT_LT(glm::length(near->normal - out), 0.1);
    const auto far = intersect(Shape(pillar), ray, near->t);
    ASSERT_TRUE(far);
    EXPECT_GT(far->t, 9);
    EXPECT_FALSE(intersect(Shape(pillar), ray, far->t));
  }
  EXPECT_FALSE(intersect(Shape(pillar), {{0, 0, 9}, {0, 0, -1}})) << "along its axis";
  EXPECT_FALSE(intersect(Shape(pillar), {{0, -9, 5.01}, {0, 1, 0}}));
  EXPECT_FALSE(intersect(Shape(pillar), {{0, -9, -0.01}, {0, 1, 0}}));
  EXPECT_TRUE(intersect(Shape(pillar), {{0, -3, 6}, {0, 1, -0.5}})) << "over its rim, on its inner wall";
}

TEST(Extrusion, ProblemsAreNamed) {
  const std::vector<CurvePoint> line{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}};
  const auto wall = [&](auto change) {
    ExtrusionMirror made;
    made.points = line;
    change(made);
    return made;
  };
  const struct {
    ExtrusionMirror mirror;
    const char* message;
  } table[] = {
      {wall([](ExtrusionMirror& w) { w.points.resize(3); }), "expected at least 4 points, got 3"},
      {wall([](ExtrusionMirror& w) {
         w.points.resize(2);
         w.closed = true;
       }),
       "expected at least 3 points, got 2"},
      {wall([](ExtrusionMirror& w) { w.height = 0; }), "expected a height > 0, got 0"},
      {wall([](ExtrusionMirror& w) { w.axis = Vector(0); }), "expected an axis that is not 0"},
      {wall([](ExtrusionMirror& w) { w.across = -3.0 * w.axis; }),
       "expected a direction across that is not along the axis"},
      {wall([](ExtrusionMirror& w) { w.across = Vector(0); }),
       "expected a direction across that is not along the axis"},
      {wall([](ExtrusionMirror& w) {
         w.points.assign(5, {1, 1});
       }),
       "expected points that span a curve, got one of length 0"},
      {wall([](ExtrusionMirror& w) {
         w.points = {{0, 0}, {2, 0}, {4, 0}, {4, 0}, {4, 0}, {4, 3}, {4, 6}};
       }),
       "expected a smooth curve, got one that has a sharp point near 4, 0"},
      {wall([](ExtrusionMirror& w) {
         w.points = {{2, 2}, {4, 0}, {2, -2}, {0, 0}, {-2, 2}, {-4, 0}, {-2, -2}, {0, 0}};
         w.closed = true;
       }),
       "expected a curve that does not meet itself, got one that does near 0, 0"},
      {wall([](ExtrusionMirror& w) { w.closed = true; }),
       "expected a smooth curve, got one that has a sharp point near"},
  };
  for (const auto& row : table) {
    const std::string problem = findShapeProblem(row.mirror).value_or("");
    EXPECT_EQ(problem.substr(0, std::string(row.message).size()), row.message) << problem;
  }
  EXPECT_EQ(findShapeProblem(ExtrusionMirror{}), std::nullopt);
}

}  // namespace
}  // namespace anamorph
