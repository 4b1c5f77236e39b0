// The print check on solids whose faults were made on purpose, so that every count is known.

#include "exports/print_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "exports/export_level.h"
#include "exports/in_dutch.h"
#include "exports/printable.h"
#include "exports/triangle_crossing.h"
#include "finished.h"
#include "geometry/random_mesh.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

using ::testing::HasSubstr;

PrintCheck check(const Mesh& mesh, int threads = 1) {
  return *checkPrint(mesh, threads);
}

// A closed solid that is not convex: a sphere or knot with a bumpy surface, moved and scaled.
Mesh makeSolid(Random& random, int kind) {
  Mesh mesh = kind % 3 == 0   ? makeSphere(1, 24)
              : kind % 3 == 1 ? makeTorusKnot(2, 3, 0.2, 96, 12)
                              : makeBox({2, 3, 4}, 5);
  const Point shift = random.inCube(100);
  const double scale = random.uniform(0.5, 40);
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return shift + scale * p; });
  return mesh;
}

TEST(PrintCheck, FindsNothingInSoundSolids) {
  for (int seed = 0; seed < 9; ++seed) {
    Random random(static_cast<std::uint32_t>(seed));
    const PrintCheck result = check(makeSolid(random, seed));
    EXPECT_TRUE(result.topology.isSound()) << seed;
    EXPECT_EQ(result.parts, 1u) << seed;
    EXPECT_EQ(result.insideOut, 0u) << seed;
    EXPECT_EQ(result.crossings.pairs, 0u) << seed;
    EXPECT_GT(result.volume, 0) << seed;
    EXPECT_THAT(findPrintProblems(result, 0), ::testing::IsEmpty()) << seed;
  }
}

TEST(PrintCheck, CountsTheEdgesOfAHole) {
  for (int seed = 0; seed < 9; ++seed) {
    Random random(static_cast<std::uint32_t>(seed));
    Mesh mesh = makeSolid(random, seed);
    const auto at = static_cast<std::ptrdiff_t>(random.uniform(0, double(mesh.triangles.size()) - 1));
    mesh.triangles.erase(mesh.triangles.begin() + at);
    const PrintCheck result = check(mesh);
    EXPECT_EQ(result.topology.borderEdges, 3u) << seed;
    EXPECT_EQ(result.topology.crowdedEdges + result.topology.turnedEdges, 0u) << seed;
    ASSERT_EQ(findPrintProblems(result, 0).size(), 1u) << seed;
    EXPECT_THAT(findPrintProblems(result, 0)[0], HasSubstr("3 edges have no neighbour"));
    EXPECT_THAT(findPrintProblems(result, 0)[0], HasSubstr("The original itself is open"));
    EXPECT_THAT(findPrintProblems(result, 7)[0], HasSubstr("7 vertices of the original did not reach"));
  }
}

TEST(PrintCheck, CountsTheEdgesOfATurnedTriangle) {
  for (int seed = 0; seed < 9; ++seed) {
    Random random(static_cast<std::uint32_t>(seed));
    Mesh mesh = makeSolid(random, seed);
    const auto at = static_cast<std::size_t>(random.uniform(0, double(mesh.triangles.size()) - 1));
    std::swap(mesh.triangles[at][0], mesh.triangles[at][1]);
    const PrintCheck result = check(mesh);
    EXPECT_EQ(result.topology.turnedEdges, 3u) << seed;
    EXPECT_EQ(result.topology.borderEdges + result.topology.crowdedEdges, 0u) << seed;
    EXPECT_EQ(result.topology.pinchedCorners, 0u) << seed;
  }
}

TEST(PrintCheck, CountsTheEdgesOfADoubledTriangle) {
  for (int seed = 0; seed < 9; ++seed) {
    Random random(static_cast<std::uint32_t>(seed));
    Mesh mesh = makeSolid(random, seed);
    const auto at = static_cast<std::size_t>(random.uniform(0, double(mesh.triangles.size()) - 1));
    mesh.triangles.push_back(mesh.triangles[at]);
    const PrintCheck result = check(mesh);
    EXPECT_EQ(result.topology.crowdedEdges, 3u) << seed;
    EXPECT_EQ(result.topology.borderEdges + result.topology.turnedEdges, 0u) << seed;
  }
}

TEST(PrintCheck, JoinsEqualPositionsFirst) {
  const Mesh sphere = makeSphere(1, 16);
  Mesh soup;  // as STL stores it: every triangle with corners of its own
  for (const Triangle& t : sphere.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.positions.size());
    for (const std::uint32_t corner : t) soup.positions.push_back(sphere.positions[corner]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  EXPECT_TRUE(check(soup).topology.isSound());
  EXPECT_EQ(check(soup).vertices, sphere.positions.size());
}

TEST(PrintCheck, CountsTrianglesThatJoiningFlattens) {
  Mesh mesh = makeBox({2, 3, 4}, 2);
  const std::size_t sound = mesh.triangles.size();
  // A needle whose two ends are the same place: nothing of it is left when equal positions are joined.
  const Point corner = mesh.positions[0];
  mesh.positions.push_back(corner);
  mesh.triangles.push_back({0, static_cast<std::uint32_t>(mesh.positions.size() - 1), 1});
  const PrintCheck result = check(mesh);
  EXPECT_EQ(result.triangles, sound + 1);
  EXPECT_EQ(result.flatTriangles, 1u);
  EXPECT_TRUE(result.topology.isSound());
}

TEST(PrintCheck, FindsPartsInsideOutAndPinchedPoints) {
  Mesh inside = makeBox({1, 1, 1}, 2);
  for (Triangle& t : inside.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(check(inside).insideOut, 1u);
  EXPECT_LT(check(inside).volume, 0);
  EXPECT_NEAR(check(inside).walls.least.thickness, 1, 1e-9) << "measured on the side where the solid is";

  Mesh boxes = makeBox({1, 1, 1}, 1);
  Mesh other = boxes;
  other.positions = mapPoints(other.positions, [](const Point& p) { return p + Vector(1, 1, 1); });
  appendMesh(boxes, other);
  const PrintCheck pinched = check(boxes);
  EXPECT_EQ(pinched.topology.pinchedCorners, 1u) << "they meet in one corner";
  EXPECT_EQ(pinched.parts, 2u);
  EXPECT_EQ(pinched.crossings.pairs, 0u) << "touching is not crossing";
}

TEST(SelfCrossings, AreTwoFacesTimesTwoWhereTetrahedraCross) {
  // The apex of the second goes through one face of the first: its three sides cross that face.
  const auto tetrahedron = [](const Point& apex, double baseZ) {
    Mesh mesh;
    for (const Point& p : {Point(-1, -1, baseZ), Point(1, -1, baseZ), Point(0, 1, baseZ), apex})
      mesh.positions.push_back(p);
    mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    if (signedVolume(mesh) < 0) {
      for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
    }
    return mesh;
  };
  Mesh mesh = tetrahedron({0, 0, 2}, 0);
  appendMesh(mesh, tetrahedron({0.03, -0.1, 0.3}, -1));
  const PrintCheck result = check(mesh);
  EXPECT_EQ(result.crossings.pairs, 3u);
  EXPECT_FALSE(result.crossings.more);
  ASSERT_TRUE(result.crossings.example);
  EXPECT_EQ(result.parts, 2u);
  EXPECT_TRUE(result.topology.isSound());
  EXPECT_THAT(findPrintProblems(result, 0)[0], HasSubstr("3 pairs of triangles"));
}

// The definition in long numbers: whether a common line has a length. Slow, and by another way.
bool crossesByClipping(const TriangleCornerPoints& s, const TriangleCornerPoints& t) {
  // The part of each triangle's plane section with the other: intervals along the common line.
  const auto section = [](const TriangleCornerPoints& plane, const TriangleCornerPoints& cut,
                          const Vector& line) -> std::pair<double, double> {
    const Vector n = glm::cross(plane[1] - plane[0], plane[2] - plane[0]);
    double low = 1e300, high = -1e300;
    for (int i = 0; i < 3; ++i) {
      const Point p = cut[i], q = cut[(i + 1) % 3];
      const double a = glm::dot(n, p - plane[0]), b = glm::dot(n, q - plane[0]);
      if ((a < 0) == (b < 0)) continue;
      const double at = glm::dot(line, p + a / (a - b) * (q - p));
      low = std::min(low, at);
      high = std::max(high, at);
    }
    return {low, high};
  };
  const Vector line = glm::cross(glm::cross(s[1] - s[0], s[2] - s[0]), glm::cross(t[1] - t[0], t[2] - t[0]));
  const auto a = section(s, t, line), b = section(t, s, line);
  return std::max(a.first, b.first) < std::min(a.second, b.second);
}

TEST(SelfCrossings, AgreeWithClippingOnRandomTriangles) {
  Random random(11);
  int crossing = 0;
  for (int i = 0; i < 20000; ++i) {
    TriangleCornerPoints s, t;
    for (int k = 0; k < 3; ++k) {
      s[k] = random.inCube(1);
      t[k] = random.inCube(1);
    }
    const bool expected = crossesByClipping(s, t);
    crossing += expected;
    ASSERT_EQ(trianglesCross(s, t), expected) << i;
    ASSERT_EQ(trianglesCross(t, s), expected) << i;
  }
  EXPECT_GT(crossing, 1000);
}

TEST(SelfCrossings, KnowCoplanarTrianglesAndTouching) {
  const TriangleCornerPoints t{Point(0, 0, 0), Point(4, 0, 0), Point(0, 4, 0)};
  const auto moved = [&](const Vector& v) { return TriangleCornerPoints{t[0] + v, t[1] + v, t[2] + v}; };
  EXPECT_TRUE(trianglesCross(t, moved({1, 1, 0})));
  EXPECT_TRUE(trianglesCross(t, t));
  EXPECT_FALSE(trianglesCross(t, moved({4, 0, 0}))) << "corner to corner";
  EXPECT_FALSE(trianglesCross(t, moved({0, 0, 1e-12}))) << "above each other";
  EXPECT_FALSE(trianglesCross(t, moved({9, 0, 0})));
  const TriangleCornerPoints standing{Point(1, 1, 0), Point(2, 1, 3), Point(1, 2, 3)};
  EXPECT_FALSE(trianglesCross(t, standing)) << "stands on it with a corner";
}

TEST(SelfCrossings, AreTheSameAsByBruteForceAndForEveryThreadCount) {
  Random random(3);
  const Mesh soup = makeSoup(random, 900, 1, 0.3);
  std::size_t expected = 0;
  const auto corners = [&](std::size_t i) {
    const Triangle& t = soup.triangles[i];
    return TriangleCornerPoints{soup.positions[t[0]], soup.positions[t[1]], soup.positions[t[2]]};
  };
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < soup.triangles.size(); ++j)
      expected += trianglesCross(corners(i), corners(j));
  }
  const Bvh bvh(soup.positions, soup.triangles);
  for (const int threads : {1, 3}) {
    const auto crossings = countSelfCrossings(soup, bvh, 1'000'000, threads);
    EXPECT_EQ(crossings->pairs, expected);
    EXPECT_FALSE(crossings->more);
  }
  EXPECT_GT(expected, 1000u);
}

TEST(Walls, OfASlabAreAsThickAsItIs) {
  for (const double thickness : {0.3, 1.0, 7.5}) {
    Mesh slab = makeBox({60, 40, thickness}, 4);
    slab.positions = mapPoints(slab.positions, [](const Point& p) {
      return Point(0.8 * p.x - 0.6 * p.z, p.y + 300, 0.6 * p.x + 0.8 * p.z);  // turned
    });
    const WallThickness walls = check(slab).walls;
    EXPECT_NEAR(walls.least.thickness, thickness, 1e-9 * thickness + 1e-12);
    EXPECT_NEAR(walls.firstPercentile, thickness, 1e-9 * thickness + 1e-12);
    EXPECT_GT(walls.samples, 60000u);
  }
}

TEST(Walls, OfABallWithAHollowAreFoundWhereTheyAreThinnest) {
  Mesh ball = makeSphere(10, 48), hollow = makeSphere(6, 48);
  hollow.positions = mapPoints(hollow.positions, [](const Point& p) { return p + Vector(3.2, 0, 0); });
  for (Triangle& t : hollow.triangles) std::swap(t[0], t[1]);
  appendMesh(ball, hollow);
  const PrintCheck result = check(ball);
  EXPECT_NEAR(result.walls.least.thickness, 0.8, 0.1);
  EXPECT_NEAR(result.walls.least.at.x, 9.6, 0.4);
  EXPECT_EQ(result.insideOut, 0u) << "a hollow faces inwards";
}

// A block with a fin on its upper side, as one closed part.
Mesh makeFinned(double finThickness, double finLength) {
  const double t = 0.5 * finThickness, l = 0.5 * finLength;
  const std::vector<std::array<double, 2>> outline{{-10, -10}, {10, -10}, {10, 0}, {t, 0},
                                                   {t, 8},     {-t, 8},   {-t, 0}, {-10, 0}};
  // The fin runs along y as far as the block: its thickness counts, and its length is the block's.
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(outline.size());
  for (const double y : {-l, l}) {
    for (const auto& [x, z] : outline) mesh.positions.push_back({x, y, z});
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    mesh.triangles.push_back({j, i, count + j});
    mesh.triangles.push_back({count + j, i, count + i});
  }
  const auto cap = [&](const std::array<std::uint32_t, 4>& quad, std::uint32_t first, bool back) {
    for (const std::array<std::size_t, 3>& corners : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
      Triangle triangle{quad[corners[0]] + first, quad[corners[1]] + first, quad[corners[2]] + first};
      if (back) std::swap(triangle[1], triangle[2]);
      mesh.triangles.push_back(triangle);
    }
  };
  for (const bool back : {false, true}) {
    const std::uint32_t first = back ? count : 0;
    cap({0, 1, 2, 3}, first, back);
    cap({0, 3, 6, 7}, first, back);
    cap({3, 4, 5, 6}, first, back);
  }
  return mesh;
}

TEST(PrintCheck, ThinWallsAreAFault) {
  struct Case {
    double thickness, smallestWidth;
    bool isFault;
  };
  for (const Case& c : {Case{0.01, 0.8, true}, Case{0.5, 0.8, true}, Case{0.5, 0.4, false},
                        Case{0.9, 0.8, false}, Case{0.9, 1.0, true}}) {
    SCOPED_TRACE(std::to_string(c.thickness) + " mm for " + std::to_string(c.smallestWidth));
    const Mesh mesh = makeFinned(c.thickness, 40);
    const PrintCheck result = *checkPrint(mesh, 1, {}, {.smallestWidth = c.smallestWidth});
    ASSERT_TRUE(result.topology.isSound());
    ASSERT_GT(result.volume, 0);
    EXPECT_NEAR(result.walls.least.thickness, c.thickness, 1e-9);
    EXPECT_NEAR(result.walls.thinArea, c.isFault ? 2 * 8 * 40 : 0, 15);
    const auto problems = findPrintProblems(result, 0);
    ASSERT_EQ(problems.size(), c.isFault ? 1u : 0u);
    if (!c.isFault) continue;
    EXPECT_THAT(problems[0], HasSubstr(fmt::format("thinner than the {:g} mm", c.smallestWidth)));
    ASSERT_FALSE(result.walls.places.empty());
    for (const ThinPlace& place : result.walls.places) {
      EXPECT_NEAR(place.at.x, 0, 1e-9) << "in the fin's middle";
      EXPECT_GE(place.at.z, 0);
    }
    const std::string json = formatJson(printCheckJson(result, 0));
    EXPECT_THAT(json, HasSubstr("\"printable\": false"));
    EXPECT_THAT(json, HasSubstr("\"atMm\": ["));
  }
}

TEST(PrintCheck, SaysWhatHelpsAgainstThinWallsAsFarAsThatIsWise) {
  PrintCheck thin;
  thin.smallestWidth = 0.8;
  thin.walls.samples = 100;
  thin.walls.thinArea = 1000;
  thin.walls.places = {{.at = {1, -2.5, 3}, .thickness = 0.1}};
  const auto advice = [&](double firstPercentile) {
    thin.walls.firstPercentile = firstPercentile;
    return findPrintProblems(thin, 0).back();
  };
  EXPECT_THAT(advice(0.4), HasSubstr("With 2 times as many millimetres per unit"));
  EXPECT_THAT(advice(0.08), HasSubstr("A larger depth scale k makes it thicker"));
  EXPECT_THAT(advice(0.08), ::testing::Not(HasSubstr("times as many")));
  EXPECT_THAT(advice(0.9), HasSubstr("Thicken the original there"));
  EXPECT_THAT(advice(0.9), HasSubstr("(1.0, -2.5, 3.0) 0.10 mm"));
  const anamorph::testing::InDutch dutch;
  EXPECT_THAT(advice(0.9), HasSubstr("(1,0; -2,5; 3,0) 0,10 mm")) << "commas are in the numbers";
}

TEST(PrintCheck, ThinSpotsAreAHintAndNoFault) {
  // A sharp tip: of a cone, of which the last bit is lost in print.
  Mesh cone;
  constexpr std::uint32_t sides = 48;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / sides;
    cone.positions.push_back({8 * std::cos(angle), 8 * std::sin(angle), 0});
  }
  cone.positions.push_back({0, 0, 40});
  cone.positions.push_back({0, 0, 0});
  for (std::uint32_t i = 0; i < sides; ++i) {
    cone.triangles.push_back({i, (i + 1) % sides, sides});
    cone.triangles.push_back({(i + 1) % sides, i, sides + 1});
  }
  const PrintCheck result = check(cone);
  ASSERT_TRUE(result.topology.isSound());
  EXPECT_LT(result.walls.least.thickness, 0.8);
  EXPECT_THAT(findPrintProblems(result, 0), ::testing::IsEmpty());
  ASSERT_EQ(findPrintHints(result).size(), 1u);
  EXPECT_THAT(findPrintHints(result)[0], HasSubstr("small spots are thinner than the 0.8 mm"));
}

TEST(PrintCheck, ASheetThatEnclosesNothingIsAFault) {
  Mesh mesh;  // a triangle and its back
  for (const Point& p : {Point(0, 0, 0), Point(9, 0, 0), Point(0, 9, 0)}) mesh.positions.push_back(p);
  mesh.triangles = {{0, 1, 2}, {0, 2, 1}};
  ASSERT_TRUE(check(mesh).topology.isSound());
  ASSERT_EQ(findPrintProblems(check(mesh), 0).size(), 1u);
  EXPECT_THAT(findPrintProblems(check(mesh), 0)[0], HasSubstr("encloses nothing"));
}

TEST(PrintCheck, IsTheSameForEveryThreadCountAndStopsWhenCancelled) {
  const Mesh knot = makeTorusKnot(2, 3, 0.45, 200, 16);
  const PrintCheck one = check(knot, 1), three = check(knot, 3);
  EXPECT_EQ(one.crossings.pairs, three.crossings.pairs);
  EXPECT_GT(one.crossings.pairs, 0u) << "so thick a knot goes through itself";
  EXPECT_EQ(one.walls.least.thickness, three.walls.least.thickness);
  EXPECT_EQ(one.walls.firstPercentile, three.walls.firstPercentile);
  EXPECT_EQ(one.walls.thinArea, three.walls.thinArea);
  const Progress progress;
  progress.token.cancel();
  EXPECT_FALSE(checkPrint(knot, 1, progress));
}

TEST(PrintCheck, StopsCountingAtItsLimitAndSaysMore) {
  Random random(5);
  const Mesh soup = makeSoup(random, 20000, 1, 0.1);
  PrintCheckLimits limits;
  limits.maxCrossings = 1000;
  const PrintCheck result = *checkPrint(soup, 0, {}, limits);
  EXPECT_TRUE(result.crossings.more);
  EXPECT_THAT(formatPrintCheck(result), HasSubstr("more than "));
}

TEST(PrintCheck, FindsTheLevelsSculpturesSound) {
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    const PrintCheck result = *checkSculpture(testing::finishedLevel(name), {});
    EXPECT_TRUE(result.topology.isSound()) << name;
    EXPECT_EQ(result.insideOut, 0u) << name;
    EXPECT_EQ(result.crossings.pairs, 0u) << name;
    EXPECT_THAT(formatPrintCheck(result), HasSubstr("faces outwards      yes")) << name;
    // The knot's sculpture gets as thin as a foil.
    const bool isThin = std::string(name) == "3-sphere";
    EXPECT_EQ(findPrintProblems(result, 0).size(), isThin ? 1u : 0u) << name;
    EXPECT_EQ(result.walls.firstPercentile < 0.1, isThin) << name;
  }
}

TEST(PrintCheck, HandlesMeshesWithoutTriangles) {
  const PrintCheck result = check({});
  EXPECT_EQ(result.triangles, 0u);
  EXPECT_EQ(result.walls.samples, 0u);
  formatPrintCheck(result);
}

}  // namespace
}  // namespace anamorph
