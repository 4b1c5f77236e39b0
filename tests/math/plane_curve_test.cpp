#include "math/plane_curve.h"

#include <cmath>

#include <gtest/gtest.h>

#include "math/vec.h"

namespace anamorph {
namespace {

using Points = std::vector<glm::dvec2>;

Points ring(int count, double from, double to, double radius = 5) {
  Points points;
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return points;
}

TEST(PlaneCurve, ContactsWithItselfAreFound) {
  const struct {
    const char* name;
    Points points;
    bool closed, meets;
  } table[] = {
      {"line", {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, false, false},
      {"wave", {{0, 0}, {1, 1}, {2, -1}, {3, 1}, {4, -1}, {5, 0}}, false, false},
      {"ring", ring(8, 0, 2 * pi), true, false},
      {"triangle", ring(3, 0, 2 * pi), true, false},
      {"nearly a ring", ring(12, 0, 2 * pi), false, false},
      {"past its beginning", ring(24, 0, 3 * pi), false, true},
      {"loop", {{0, 0}, {2, 0}, {4, 0}, {5, 3}, {3, 4}, {2, 2}, {4, -2}, {6, -4}}, false, true},
      {"eight", {{0, 0}, {2, 2}, {4, 0}, {2, -2}, {0, 0}, {-2, 2}, {-4, 0}, {-2, -2}}, true, true},
      {"there and back",
       {{-2, 0}, {0, 0}, {2, 0}, {4, 0}, {4.5, 0.5}, {4, 1}, {2, 0}, {0, 0}, {-2, 0}},
       false,
       true},
  };
  for (const auto& row : table) {
    const PlaneCurve curve = splineCurve(row.points, row.closed);
    EXPECT_EQ(findSharpPoint(curve, 10), std::nullopt) << row.name;
    EXPECT_EQ(findSelfContact(curve, row.closed, 1e-6).has_value(), row.meets) << row.name;
  }
}

// Two long walls of one curve, nearly parallel: as far apart as they are, and not nearer.
TEST(PlaneCurve, TouchingIsToldFromNearlyTouching) {
  for (const double gap : {1e-2, 1e-4, 1e-5}) {
    Points points{{0, 0},  {10, 0}, {20, 0},   {30, 0},   {33, 1},
                  {33, 3}, {30, 3}, {20, gap}, {10, gap}, {0, gap}};
    EXPECT_FALSE(findSelfContact(splineCurve(points, false), false, 1e-6)) << gap;
    EXPECT_TRUE(findSelfContact(splineCurve(points, false), false, 2 * gap)) << gap;
  }
}

TEST(PlaneCurve, SharpPointsAreFound) {
  EXPECT_FALSE(findSharpPoint(splineCurve(ring(5, 0, 2 * pi), true), 10));
  EXPECT_TRUE(findSharpPoint(splineCurve(Points(4, {1, 2}), false), 1)) << "a point";
  // Three control points at one place stop the curve.
  const auto corner =
      findSharpPoint(splineCurve(Points{{0, 0}, {2, 0}, {4, 0}, {4, 0}, {4, 0}, {4, 3}, {4, 6}}, false), 6);
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->x, 4, 1e-6);
  EXPECT_NEAR(corner->y, 0, 1e-6);
  EXPECT_TRUE(findSharpPoint(splineCurve(Points{{0, 0}, {6, 0}, {0, 0}, {6, 0}}, false), 1))
      << "it turns back";
}

TEST(PlaneCurve, ComesNearItsOwnPointsOnly) {
  const PlaneCurve curve = splineCurve(Points{{0, 0}, {1, 1}, {2, -1}, {3, 1}, {4, -1}, {5, 0}}, false);
  for (const PlaneCubic& piece : curve) {
    for (double u = 0; u <= 1; u += 0.1) {
      const glm::dvec2 p(valueAndSlope(piece.x, u).value, valueAndSlope(piece.y, u).value);
      EXPECT_TRUE(comesNear(curve, p, 1e-9));
      EXPECT_FALSE(comesNear(curve, p + glm::dvec2(0, 1e-3), 1e-5));
    }
  }
}

}  // namespace
}  // namespace anamorph
