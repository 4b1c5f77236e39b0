#include "geometry/bvh.h"

#include <limits>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <string>

#include "base/check.h"
#include "geometry/random_mesh.h"
#include "geometry/shapes.h"

namespace anamorph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where the ray meets a triangle that is larger by `margin` on every side (in barycentrics); infinity for a
/// miss.
double intersectInDouble(const Mesh& mesh, const Triangle& t, const Ray& ray, double margin) {
  const Point a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
  const Vector p = glm::cross(ray.direction, c - a), s = ray.origin - a, q = glm::cross(s, b - a);
  const double determinant = glm::dot(b - a, p);
  if (determinant == 0) return infinity;
  const double u = glm::dot(s, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  const bool inside = u >= -margin && v >= -margin && u + v <= 1 + margin;
  return inside ? glm::dot(c - a, q) / determinant : infinity;
}

double nearestInDouble(const Mesh& mesh, const Ray& ray, double margin, double tMin, double tMax) {
  double nearest = infinity;
  for (const Triangle& t : mesh.triangles) {
    const double at = intersectInDouble(mesh, t, ray, margin);
    if (at > tMin && at < tMax) nearest = std::min(nearest, at);
  }
  return nearest;
}

/// The tree decides in float who is hit beside an edge. So its answer lies between those of slightly larger
/// and slightly smaller triangles.
void expectAsBruteForce(const Bvh& bvh, const Mesh& mesh, const Ray& ray, double tMin = 0,
                        double tMax = infinity) {
  constexpr double margin = 1e-4;
  BvhHit hit;
  const bool found = bvh.closestHit(ray, hit, tMin, tMax);
  const double t = found ? hit.t : infinity;
  const double soonest = nearestInDouble(mesh, ray, margin, tMin, tMax);
  const double latest = nearestInDouble(mesh, ray, -margin, tMin, tMax);
  EXPECT_GE(t, soonest * (1 - 1e-9));
  EXPECT_LE(t, latest * (1 + 1e-9));
  EXPECT_EQ(bvh.anyHit(ray, tMin, tMax), found);
  if (!found) return;
  EXPECT_GT(t, tMin);
  EXPECT_LT(t, tMax);
  const Triangle& corners = mesh.triangles[hit.triangle];
  const Point a = mesh.positions[corners[0]], b = mesh.positions[corners[1]], c = mesh.positions[corners[2]];
  const double size = glm::length(b - a) + glm::length(c - a);
  EXPECT_TRUE(hit.u >= 0 && hit.v >= 0 && 1 - hit.u - hit.v >= 0) << hit.u << " " << hit.v;
  EXPECT_LE(glm::length((1 - hit.u - hit.v) * a + hit.u * b + hit.v * c - ray.at(t)), 2 * margin * size);
}

Mesh transformed(Mesh mesh, double scale, const Vector& shift) {
  mesh.positions = mapPoints(mesh.positions, [&](const Point& p) { return scale * p + shift; });
  return mesh;
}

struct Scene {
  std::string name;
  std::function<Mesh(Random&)> make;
  double reach;  // rays start and aim within this distance of the centre
  Point centre{0};
};
void PrintTo(const Scene& scene, std::ostream* out) {
  *out << scene.name;
}

class BvhScenes : public testing::TestWithParam<Scene> {};

TEST_P(BvhScenes, AgreeWithBruteForceAlsoAfterRefit) {
  const Scene& scene = GetParam();
  const std::uint32_t seed = 20231;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  Mesh mesh = scene.make(random);
  Bvh bvh(mesh.positions, mesh.triangles);
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 1500; ++i) {
      const Point origin = scene.centre + random.inCube(2 * scene.reach);
      const Point target = scene.centre + random.inCube(scene.reach);
      const Ray ray{origin, glm::normalize(target - origin)};
      expectAsBruteForce(bvh, mesh, ray);
      expectAsBruteForce(bvh, mesh, ray, random.uniform(0, 2) * scene.reach,
                         random.uniform(0, 5) * scene.reach);
    }
    mesh.positions = mapPoints(mesh.positions, [&](const Point& p) {
      const Vector q = (p - scene.centre) / scene.reach;
      return scene.centre + scene.reach * (q + 0.3 * Vector(std::sin(2 * q.y), std::cos(3 * q.z), q.x * q.y));
    });
    bvh.refit(mesh.positions);
  }
}

/// The mesh with a single point in the place of every triangle that has an absent corner.
Mesh presentPart(const Mesh& mesh, const std::vector<std::uint8_t>& absent) {
  Mesh part = mesh;
  for (Triangle& t : part.triangles) {
    if (absent[t[0]] != 0 || absent[t[1]] != 0 || absent[t[2]] != 0) t = {t[0], t[0], t[0]};
  }
  return part;
}

TEST_P(BvhScenes, AbsentPointsTakeTheirTrianglesAwayUntilTheNextRefit) {
  const Scene& scene = GetParam();
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Mesh mesh = scene.make(random);
    Bvh bvh(mesh.positions, mesh.triangles);
    const Bvh whole = bvh;
    PointArray points = mesh.positions;
    std::vector<std::uint8_t> absent(points.size());
    const double fraction = seed == 0 ? 0 : random.uniform(0, 0.7);
    for (std::size_t i = 0; i < absent.size(); ++i) {
      if (random.uniform(0, 1) >= fraction) continue;
      absent[i] = static_cast<std::uint8_t>(random.uniform(1, 255.99));
      points.set(i, 1e4 * scene.reach * random.inCube(1));  // wherever an absent point is, it costs nothing
    }
    bvh.refit(points, 1 + static_cast<int>(seed % 2), absent);
    const Mesh present = presentPart(mesh, absent);
    Mesh built{mesh.positions, {}};
    std::vector<std::uint32_t> indexOf;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      if (present.triangles[t] != mesh.triangles[t]) continue;
      built.triangles.push_back(mesh.triangles[t]);
      indexOf.push_back(t);
    }
    const Bvh fresh(built.positions, built.triangles);
    int differences = 0;
    for (int i = 0; i < 300; ++i) {
      const Point origin = scene.centre + random.inCube(2 * scene.reach);
      const Point target = scene.centre + random.inCube(scene.reach);
      const Ray ray{origin, glm::normalize(target - origin)};
      expectAsBruteForce(bvh, present, ray);
      BvhHit hit, freshHit;
      const bool found = bvh.closestHit(ray, hit), freshFound = fresh.closestHit(ray, freshHit);
      differences += found != freshFound || (found && hit.triangle != indexOf[freshHit.triangle]);
    }
    EXPECT_LE(differences, 2) << "only rays beside an edge, where floats decide";

    bvh.refit(mesh.positions);
    EXPECT_EQ(bvh.nodes(), whole.nodes());
    for (int i = 0; i < 100; ++i) {
      const Ray ray{scene.centre + random.inCube(2 * scene.reach), random.direction()};
      BvhHit hit, wholeHit;
      ASSERT_EQ(bvh.closestHit(ray, hit), whole.closestHit(ray, wholeHit));
      EXPECT_EQ(hit.t, wholeHit.t);
      EXPECT_EQ(hit.triangle, wholeHit.triangle);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Bvh, BvhScenes,
    testing::Values(Scene{"Soup", [](Random& r) { return makeSoup(r, 300, 1, 0.3); }, 1},
                    Scene{"Few", [](Random& r) { return makeSoup(r, 3, 1, 1); }, 1},
                    Scene{"Tiny", [](Random& r) { return makeSoup(r, 200, 1e-6, 3e-7); }, 1e-6},
                    Scene{"Huge", [](Random& r) { return makeSoup(r, 200, 1e6, 3e5); }, 1e6},
                    Scene{"FarFromTheOrigin",
                          [](Random& r) {
                            return transformed(makeSoup(r, 200, 1, 0.3), 1, Vector(3000, -2000, 500));
                          },
                          1,
                          {3000, -2000, 500}},
                    Scene{"OfAllSizes",
                          [](Random& r) {
                            Mesh mesh;
                            for (std::uint32_t i = 0; i < 200; ++i) {
                              const double size = std::pow(10, r.uniform(-3, 0));
                              const Point p = r.inCube(1);
                              for (int c = 0; c < 3; ++c) mesh.positions.push_back(p + r.inCube(size));
                              mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
                            }
                            return mesh;
                          },
                          1},
                    Scene{"Sphere", [](Random&) { return makeSphere(1, 24); }, 1},
                    Scene{"Thin",
                          [](Random& r) {
                            Mesh mesh = makeSoup(r, 200, 1, 0.3);
                            mesh.positions = mapPoints(
                                mesh.positions, [](const Point& p) { return Point(p.x, p.y, 1e-3 * p.z); });
                            return mesh;
                          },
                          1}),
    [](const testing::TestParamInfo<Scene>& scene) { return scene.param.name; });

TEST(Bvh, IsWatertightFromInside) {
  const std::uint32_t seed = 7;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const Mesh sphere = makeSphere(1, 200);
  const Bvh bvh(sphere.positions, sphere.triangles);
  int misses = 0, badWeights = 0;
  const auto shoot = [&](const Point& origin, const Point& target) {
    BvhHit hit;
    const bool found = bvh.closestHit({origin, glm::normalize(target - origin)}, hit);
    misses += !found || std::abs(hit.t - glm::length(target - origin)) > 1e-3;
    badWeights += !(hit.u >= 0 && hit.v >= 0 && 1 - hit.u - hit.v >= 0);
  };
  for (int i = 0; i < 100'000; ++i) {
    BvhHit hit;
    misses += !bvh.closestHit({random.inCube(0.5), random.direction()}, hit);
  }
  for (const Point& origin : {Point(0), Point(0.25, -0.125, 0.5), Point(0.1, 0.2, -0.3)}) {
    for (const Triangle& t : sphere.triangles) {
      for (int i = 0; i < 3; ++i) {
        const Point a = sphere.positions[t[i]], b = sphere.positions[t[(i + 1) % 3]];
        shoot(origin, a);
        shoot(origin, 0.5 * (a + b));
      }
    }
  }
  EXPECT_EQ(misses, 0);
  EXPECT_EQ(badWeights, 0);
}

TEST(Bvh, IsWatertightAlongTheAxes) {
  const Mesh box = makeBox({2, 2, 2}, 8);
  const Bvh bvh(box.positions, box.triangles);
  // From grid points to the walls: every ray ends exactly on a vertex, and runs within planes of box sides.
  for (int axis = 0; axis < 3; ++axis) {
    for (int sign = -1; sign <= 1; sign += 2) {
      for (int i = -3; i <= 3; ++i) {
        for (int j = -3; j <= 3; ++j) {
          Point origin(0);
          Vector direction(0);
          direction[axis] = sign;
          origin[(axis + 1) % 3] = i * 0.25;
          origin[(axis + 2) % 3] = j * 0.25;
          BvhHit hit;
          ASSERT_TRUE(bvh.closestHit({origin, direction}, hit))
              << axis << " " << sign << " " << i << " " << j;
          EXPECT_EQ(hit.t, 1);
          EXPECT_TRUE(bvh.anyHit({origin, direction}));
        }
      }
    }
  }
}

Mesh oneTriangle() {
  Mesh mesh;
  for (const Point& p : {Point(0, 0, 1), Point(1, 0, 1), Point(0, 1, 1)}) mesh.positions.push_back(p);
  mesh.triangles.push_back({0, 1, 2});
  return mesh;
}

TEST(Bvh, OfNothingHitsNothing) {
  BvhHit hit;
  hit.triangle = 17;
  Bvh unbuilt, empty{PointArray(), {}}, onlyPoints{oneTriangle().positions, {}};
  onlyPoints.refit(oneTriangle().positions);
  for (const Bvh* bvh : {&unbuilt, &empty, &onlyPoints}) {
    EXPECT_TRUE(bvh->empty());
    EXPECT_FALSE(bvh->closestHit({Point(0), Vector(0, 0, 1)}, hit));
    EXPECT_FALSE(bvh->anyHit({Point(0), Vector(0, 0, 1)}));
  }
  EXPECT_EQ(hit.triangle, 17u);
}

TEST(Bvh, HitHasPointOfTriangle) {
  const Mesh mesh = oneTriangle();
  const Bvh bvh(mesh.positions, mesh.triangles);
  for (const double z : {0.0, 3.0}) {
    BvhHit hit;
    ASSERT_TRUE(bvh.closestHit({{0.2, 0.3, z}, {0, 0, z > 1 ? -1 : 1}}, hit));
    EXPECT_DOUBLE_EQ(hit.t, std::abs(z - 1));
    EXPECT_DOUBLE_EQ(hit.u, 0.2);
    EXPECT_DOUBLE_EQ(hit.v, 0.3);
  }
  EXPECT_FALSE(bvh.anyHit({{0.6, 0.6, 0}, {0, 0, 1}}));
  EXPECT_FALSE(bvh.anyHit({{0.2, 0.2, 2}, {0, 0, 1}}));
}

TEST(Bvh, LimitsAreExact) {
  const Mesh mesh = oneTriangle();
  const Bvh bvh(mesh.positions, mesh.triangles);
  const Ray ray{{0.2, 0.3, 0}, {0, 0, 1}};
  const double before = std::nextafter(1.0, 0.0), after = std::nextafter(1.0, 2.0);
  const struct {
    double tMin, tMax;
    bool met;
  } table[] = {{0, 1, false},      {0, after, true},  {1, infinity, false},  {before, infinity, true},
               {before, 1, false}, {1, after, false}, {before, after, true}, {0, 0, false},
               {2, 0.5, false}};
  for (const auto& row : table) {
    BvhHit hit;
    EXPECT_EQ(bvh.closestHit(ray, hit, row.tMin, row.tMax), row.met) << row.tMin << " " << row.tMax;
    EXPECT_EQ(bvh.anyHit(ray, row.tMin, row.tMax), row.met) << row.tMin << " " << row.tMax;
  }
}

TEST(Bvh, RaysFromItsOwnSurfaceDoNotMeetItAgain) {
  Random random(5);
  const Mesh sphere = makeSphere(1, 100);
  const Bvh bvh(sphere.positions, sphere.triangles);
  for (int i = 0; i < 20'000; ++i) {
    BvhHit hit;
    const Ray ray{3.0 * random.direction(), random.direction()};
    if (!bvh.closestHit(ray, hit)) continue;
    const Point p = ray.at(hit.t);
    const Direction outwards = glm::normalize(areaVector(sphere.positions, sphere.triangles[hit.triangle]));
    EXPECT_FALSE(bvh.anyHit({p, outwards}, 1e-12));
  }
}

TEST(Bvh, DistancesAreAsExactAsDoubles) {
  // The tree is float inside; what comes out must not be. Also from a million times the mesh's size away.
  Random random(11);
  const Vector centre(100, 200, -300);
  const Mesh mesh = transformed(makeSphere(1, 60), 1, centre);
  const Bvh bvh(mesh.positions, mesh.triangles);
  for (const double distance : {0.0, 3.0, 1e3, 1e6}) {
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
      const Point origin = centre + distance * random.direction(), target = centre + random.inCube(0.5);
      const Ray ray{origin, glm::normalize(target - origin)};
      BvhHit hit;
      if (!bvh.closestHit(ray, hit)) continue;
      ++hits;
      const Triangle& t = mesh.triangles[hit.triangle];
      const Vector normal = areaVector(mesh.positions, t);
      const double expected =
          glm::dot(normal, mesh.positions[t[0]] - origin) / glm::dot(normal, ray.direction);
      EXPECT_NEAR(hit.t, expected, 1e-12 * (1 + distance));
    }
    EXPECT_EQ(hits, 1000) << distance;
  }
}

TEST(Bvh, StrayUnusedPointsCostNoAccuracy) {
  Mesh mesh = makeSphere(1, 60);
  mesh.positions.push_back({1e9, -1e9, 1e9});
  Bvh bvh(mesh.positions, mesh.triangles);
  bvh.refit(mesh.positions);
  EXPECT_LT(glm::length(bvh.centre()), 1e-6);
  expectAsBruteForce(bvh, mesh, {{0, 0, 5}, glm::normalize(Vector(0.01, 0.02, -1))});
}

TEST(Bvh, TrianglesWithoutAreaAreNeverHit) {
  Mesh mesh;
  for (const Point& p : {Point(-1, 0, 1), Point(1, 0, 1), Point(0, 0, 1), Point(0.5, 0.25, 2)}) {
    mesh.positions.push_back(p);
  }
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}, {2, 2, 2}, {1, 2, 1}, {3, 3, 3}};
  const Bvh bvh(mesh.positions, mesh.triangles);
  for (const Point& target : {Point(0, 0, 1), Point(0.5, 0, 1), Point(-1, 0, 1), Point(0.5, 0.25, 2)}) {
    for (const Point& origin : {Point(0, 0, -3), Point(0.1, 0.7, 0.3), Point(0, 0.5, 1)}) {
      EXPECT_FALSE(bvh.anyHit({origin, glm::normalize(target - origin)}));
    }
  }
}

TEST(Bvh, TrianglesWithoutAreaOnlyInDoubleAreNeverHitEither) {
  // Corners 0, p and 2 p: exactly collinear, but seldom so once rounded to float and sheared.
  Random random(23);
  Mesh mesh;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Point p = random.inCube(1);
    for (int corner = 0; corner < 3; ++corner) mesh.positions.push_back(static_cast<double>(corner) * p);
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Bvh bvh(mesh.positions, mesh.triangles);
  for (int i = 0; i < 20'000; ++i) {
    const Point target = random.uniform(0, 1) * mesh.positions[3 * (i % 200) + 2], origin = random.inCube(3);
    EXPECT_FALSE(bvh.anyHit({origin, glm::normalize(target - origin)}));
  }
}

TEST(Bvh, SliversLeaveNoGap) {
  // A fan of a million-to-one slivers that tile a square.
  Mesh mesh;
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, 0)})
    mesh.positions.push_back(p);
  for (int i = 0; i <= 100; ++i) mesh.positions.push_back({0.5 + 1e-6 * (i - 50), 0.3, 0});
  const auto at = [](int i) { return static_cast<std::uint32_t>(4 + i); };
  for (int i = 0; i < 100; ++i) {
    mesh.triangles.push_back({0, at(i + 1), at(i)});
    mesh.triangles.push_back({2, at(i), at(i + 1)});
  }
  mesh.triangles.insert(mesh.triangles.end(),
                        {{0, 1, at(100)}, {1, 2, at(100)}, {2, 3, at(0)}, {3, 0, at(0)}});
  const Bvh bvh(mesh.positions, mesh.triangles);
  Random random(13);
  for (int i = 0; i < 20'000; ++i) {
    const Point target(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99), 0);
    const Point origin = target + Vector(random.uniform(-1, 1), random.uniform(-1, 1), 1);
    BvhHit hit;
    ASSERT_TRUE(bvh.closestHit({origin, glm::normalize(target - origin)}, hit)) << i;
    EXPECT_NEAR(hit.t, glm::length(target - origin), 1e-9);
  }
}

TEST(Bvh, IdenticalTrianglesAreOneTriangle) {
  Mesh mesh = oneTriangle();
  mesh.triangles.resize(10'000, mesh.triangles[0]);
  const Bvh bvh(mesh.positions, mesh.triangles);
  BvhHit hit;
  ASSERT_TRUE(bvh.closestHit({{0.2, 0.3, 0}, {0, 0, 1}}, hit));
  EXPECT_DOUBLE_EQ(hit.t, 1);
}

TEST(Bvh, FlatMeshesAreHitAcrossAndNotAlong) {
  Mesh mesh = makeBox({2, 2, 2}, 16);
  mesh.positions = mapPoints(mesh.positions, [](const Point& p) { return Point(p.x, p.y, 0.1); });
  const Bvh bvh(mesh.positions, mesh.triangles);
  Random random(17);
  for (int i = 0; i < 2000; ++i) {
    const Point target(random.uniform(-1, 1), random.uniform(-1, 1), 0.1), origin(0.3, 0.4, 5);
    BvhHit hit;
    ASSERT_TRUE(bvh.closestHit({origin, glm::normalize(target - origin)}, hit));
    EXPECT_NEAR(hit.t, glm::length(target - origin), 1e-12);
    EXPECT_FALSE(bvh.anyHit({{-5, target.y, 0.1}, {1, 0, 0}}));
  }
}

TEST(Bvh, NothingIsHitWhenAllPointsAreAbsent) {
  const std::uint32_t seed = 29;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (const Mesh& mesh : {oneTriangle(), makeSphere(1, 30), makeSoup(random, 200, 1, 0.3)}) {
    Bvh bvh(mesh.positions, mesh.triangles);
    const Bvh whole = bvh;
    bvh.refit(mesh.positions, 1, std::vector<std::uint8_t>(mesh.positions.size(), 1));
    for (int i = 0; i < 2000; ++i) {
      BvhHit hit;
      const Ray ray{random.inCube(3), random.direction()};
      ASSERT_FALSE(bvh.closestHit(ray, hit)) << i;
      ASSERT_FALSE(bvh.anyHit(ray)) << i;
    }
    for (const Vector& axis : {Vector(1, 0, 0), Vector(0, -1, 0), Vector(0, 0, 1)}) {
      EXPECT_FALSE(bvh.anyHit({Point(0), axis}));
      EXPECT_FALSE(bvh.anyHit({Point(0.25, 0.25, 0) - 5.0 * axis, axis}));
    }
    EXPECT_TRUE(isFinite(bvh.centre()));
    bvh.refit(mesh.positions);
    EXPECT_EQ(bvh.nodes(), whole.nodes());
  }
}

TEST(Bvh, AbsentUnusedPointsChangeNothing) {
  Mesh mesh = makeSphere(1, 20);
  mesh.positions.push_back({3, 3, 3});
  Bvh bvh(mesh.positions, mesh.triangles);
  const Bvh whole = bvh;
  std::vector<std::uint8_t> absent(mesh.positions.size());
  absent.back() = 1;
  bvh.refit(mesh.positions, 1, absent);
  EXPECT_EQ(bvh.nodes(), whole.nodes());
}

TEST(Bvh, MisuseIsReported) {
  const Mesh mesh = oneTriangle();
  const std::vector<Triangle> bad{{0, 1, 3}};
  EXPECT_THROW(Bvh(mesh.positions, bad), ProgrammingError);
  Bvh bvh(mesh.positions, mesh.triangles);
  EXPECT_THROW(bvh.refit(PointArray(2)), ProgrammingError);
  EXPECT_THROW(bvh.refit(mesh.positions, 1, std::vector<std::uint8_t>(2)), ProgrammingError);
}

TEST(Bvh, RaysThatAreNoRaysMeetNothing) {
  const Mesh mesh = makeSphere(1, 64);
  const Bvh bvh(mesh.positions, mesh.triangles);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Ray& ray :
       {Ray{{nan, 0, 0}, {1, 0, 0}}, Ray{{nan, nan, nan}, {nan, nan, nan}}, Ray{{0, 0, 0}, {0, nan, 1}},
        Ray{{0, 0, 0}, {0, 0, 0}}, Ray{{infinity, 0, 0}, {-1, 0, 0}}, Ray{{0, 0, 0}, {infinity, 0, 0}}}) {
    BvhHit hit;
    EXPECT_FALSE(bvh.closestHit(ray, hit));
    EXPECT_FALSE(bvh.anyHit(ray));
  }
}

}  // namespace
}  // namespace anamorph
