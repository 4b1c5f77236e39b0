#include "geometry/polygon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

#include "base/check.h"
#include "math/frame.h"

namespace anamorph {
namespace {

using Polygon = std::vector<glm::dvec2>;

PointArray place(const Polygon& polygon, const Frame& frame) {
  PointArray points;
  for (const glm::dvec2& p : polygon)
    points.push_back(p.x * frame.right + p.y * frame.up + 3.0 * frame.forward);
  return points;
}

std::vector<Triangle> cut(const PointArray& points) {
  std::vector<std::uint32_t> corners(points.size());
  std::iota(corners.begin(), corners.end(), 0u);
  std::vector<Triangle> triangles;
  triangulatePolygon(points, corners, triangles);
  return triangles;
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

// n - 2 triangles, none of them flipped, that cover the polygon's area: then they overlap nowhere and leave
// no gap.
void expectExactCover(const Polygon& polygon, const Frame& frame, const std::string& what) {
  const PointArray points = place(polygon, frame);
  const std::vector<Triangle> triangles = cut(points);
  ASSERT_EQ(triangles.size(), polygon.size() - 2) << what;
  double sum = 0;
  for (const Triangle& t : triangles) {
    const double one = -glm::dot(areaVector(points, t), frame.forward) / 2;
    EXPECT_GE(one, -1e-12) << what;
    sum += one;
  }
  EXPECT_NEAR(sum, area(polygon), 1e-9 * area(polygon)) << what;
}

TEST(Polygon, AConvexQuadIsCutFromItsFirstCorner) {
  EXPECT_EQ(cut(place({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {})), (std::vector<Triangle>{{0, 1, 2}, {2, 3, 0}}));
}

TEST(Polygon, AnArrowHeadIsCutAlongItsOnlyInnerDiagonal) {
  const auto triangles = cut(place({{-1, -1}, {0, 0}, {1, -1}, {0, 2}}, {}));
  ASSERT_EQ(triangles.size(), 2u);
  for (const Triangle& t : triangles) {
    EXPECT_EQ(std::count(t.begin(), t.end(), 1u), 1);
    EXPECT_EQ(std::count(t.begin(), t.end(), 3u), 1);
  }
}

TEST(Polygon, ConcaveOnesInEveryPlaneAndFromEveryFirstCorner) {
  const std::map<std::string, Polygon> polygons{
      {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}},
      {"comb",
       {{0, 0}, {9, 0}, {9, 5}, {7, 5}, {7, 1}, {5, 1}, {5, 5}, {4, 5}, {4, 1}, {2, 1}, {2, 5}, {0, 5}}},
      {"spiral",
       {{0, 0}, {5, 0}, {5, 5}, {1, 5}, {1, 2}, {3, 2}, {3, 3}, {2, 3}, {2, 4}, {4, 4}, {4, 1}, {0, 1}}},
      {"corners on edges", {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {2, 2}, {1, 1}}},
      {"slit to a hole", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}}};
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const auto& [name, original] : polygons) {
    Polygon polygon = original;
    for (std::size_t first = 0; first < polygon.size(); ++first) {
      expectExactCover(polygon, {}, name);
      for (int i = 0; i < 10; ++i) {
        const Direction forward = glm::normalize(Vector(uniform(random), uniform(random), uniform(random)));
        // Tilted planes round the corners that lie on edges.
        if (name != "corners on edges")
          expectExactCover(polygon, makeFrame(forward, {0, 0, 1}), name + ", seed 11");
      }
      std::rotate(polygon.begin(), polygon.begin() + 1, polygon.end());
    }
  }
}

TEST(Polygon, RandomStarsAreCoveredExactly) {
  for (unsigned seed = 0; seed < 1000; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const int count = 3 + static_cast<int>(random() % 60);
    Polygon star;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * pi * i / count, radius = 1.1 + uniform(random);
      star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    const Direction forward = glm::normalize(Vector(uniform(random), uniform(random), uniform(random)));
    expectExactCover(star, makeFrame(forward, {0, 0, 1}), "seed " + std::to_string(seed));
  }
}

TEST(Polygon, RepeatedCornersAreLeftOut) {
  const PointArray points = place({{0, 0}, {1, 0}, {0, 1}}, {});
  const std::vector<std::uint32_t> corners{0, 0, 1, 1, 2, 2, 0}, two{0, 1, 1, 0}, one{2, 2, 2};
  std::vector<Triangle> triangles;
  triangulatePolygon(points, two, triangles);
  triangulatePolygon(points, one, triangles);
  EXPECT_TRUE(triangles.empty());
  triangulatePolygon(points, corners, triangles);
  ASSERT_EQ(triangles.size(), 1u);
  EXPECT_DOUBLE_EQ(areaVector(points, triangles[0]).z, 1);
}

TEST(Polygon, ACornerThatComesBackMakesNoTriangleWithItself) {
  const PointArray points = place({{0, 0}, {1, 0}, {0, 1}}, {});
  const std::vector<std::uint32_t> thereAndBack{0, 1, 0, 2}, eight{0, 1, 2, 0, 2, 1};
  std::vector<Triangle> triangles;
  triangulatePolygon(points, thereAndBack, triangles);
  triangulatePolygon(points, eight, triangles);
  EXPECT_FALSE(triangles.empty());
  for (const Triangle& t : triangles) EXPECT_TRUE(t[0] != t[1] && t[1] != t[2] && t[2] != t[0]);
}

TEST(Polygon, DegenerateOnesStillGiveTheirNumberOfTriangles) {
  const std::map<std::string, Polygon> polygons{
      {"bow tie", {{0, 0}, {1, 1}, {1, 0}, {0, 1}}},
      {"on a line", {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {1.5, 0}}},
      {"one point", Polygon(7, {1, 1})},
      {"pentagram", {{0, 3}, {2, -3}, {-3, 1}, {3, 1}, {-2, -3}}},
      {"tiny", {{0, 0}, {1e-300, 0}, {1e-300, 1e-300}, {0, 1e-300}}}};
  for (const auto& [name, polygon] : polygons)
    EXPECT_EQ(cut(place(polygon, {})).size(), polygon.size() - 2) << name;
}

TEST(Polygon, ManyCornersAreCutInTime) {
  Polygon comb;
  const int teeth = 10'000;
  for (int i = 0; i < teeth; ++i) {
    for (const glm::dvec2 p : {glm::dvec2(0, 0), {0.5, 0}, {0.5, 1}, {1, 1}})
      comb.emplace_back(-i - p.x, p.y + 1);
  }
  comb[0] = {0, -2};
  comb.back() = {-teeth, -2};
  expectExactCover(comb, {}, "comb");
}

TEST(Polygon, ManyCornersOfAStarAreCutInTime) {
  Polygon star;
  const int count = static_cast<int>(maxPolygonCorners);
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * pi * i / count, radius = i % 2 == 0 ? 3 : 2.9;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  expectExactCover(star, {}, "star");
}

TEST(Polygon, ManyCornersThatCrossThemselvesEndInTime) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Polygon tangle;
  for (int i = 0; i < 100'000; ++i) tangle.emplace_back(uniform(random), uniform(random));
  EXPECT_EQ(cut(place(tangle, {})).size(), tangle.size() - 2);
}

TEST(Polygon, MoreThanTheMostCornersIsAProgrammingError) {
  EXPECT_THROW(cut(PointArray(maxPolygonCorners + 1)), ProgrammingError);
}

TEST(Polygon, ASoupKeepsTheOrderOfItsPolygons) {
  PolygonSoup soup{{0, 1, 2, 0, 1, 2, 3, 1, 1, 2, 2, 3, 0}, {3, 4, 0, 3, 3}, 1};
  const PointArray points = place({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {});
  EXPECT_EQ(triangulate(points, soup), (std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {2, 3, 0}, {2, 3, 0}}));
}

}  // namespace
}  // namespace anamorph
