#include "optics/mesh_mirror.h"

#include <cmath>
#include <cstdlib>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "geometry/normals.h"
#include "geometry/shapes.h"
#include "optics/optic.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

MeshMirror mirrorOf(SmoothMesh surface, const Placement& placement = {}) {
  return shapeAs<MeshMirror>(meshMirror(std::move(surface), placement));
}

MeshMirror mirrorOf(Mesh mesh, const Placement& placement = {}) {
  return mirrorOf(withSmoothNormals(std::move(mesh)), placement);
}

// Closed, and every ray from the origin meets it once.
Mesh makeBumpyBall(Random& random) {
  Mesh mesh = weldPositions(makeSphere(1, random.integer(6, 24))).mesh;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    mesh.positions.set(i, random.uniform(0.5, 3) * mesh.positions[i]);
  return mesh;
}

// What the trees are to be proved against: every triangle, in double alone.
std::optional<BvhHit> nearestOfAll(const Mesh& mesh, const Ray& ray) {
  std::optional<BvhHit> nearest;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    const Point a = mesh.positions[c[0]], b = mesh.positions[c[1]], d = mesh.positions[c[2]];
    const Vector n = glm::cross(b - a, d - a);
    const double along = glm::dot(n, ray.direction), distance = glm::dot(n, a - ray.origin) / along;
    const Point q = ray.origin + distance * ray.direction;
    const double u = glm::dot(glm::cross(d - q, a - q), n) / lengthSquared(n),
                 v = glm::dot(glm::cross(a - q, b - q), n) / lengthSquared(n);
    if (along == 0 || distance <= 0 || u < 0 || v < 0 || u + v > 1) continue;
    if (!nearest || distance < nearest->t) nearest = BvhHit{t, distance, u, v};
  }
  return nearest;
}

// ANAMORPH_MANY_RAYS=1: a million.
TEST(MeshMirror, NoRayThroughAnEdgeOrAVertexIsLost) {
  const int scenes = std::getenv("ANAMORPH_MANY_RAYS") ? 500 : 25, rays = 2000;
  for (int seed = 0; seed < scenes; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<unsigned>(seed));
    const Mesh mesh = makeBumpyBall(random);
    const Vector away = seed % 3 == 0 ? random.point(1000) : Vector(0);
    const Shape shape = mirrorOf(mesh, {.position = away});
    const PointArray placed = mapPoints(mesh.positions, [&](const Point& p) { return away + p; });
    for (int i = 0; i < rays; ++i) {
      const Triangle& t = mesh.triangles[static_cast<std::size_t>(
          random.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
      const double share = i % 2 == 0 ? 0 : random.uniform(0, 1);
      const Point aim = glm::mix(placed[t[0]], placed[t[1]], share);
      const auto hit = intersect(shape, {away, aim - away});
      ASSERT_TRUE(hit) << "towards " << aim.x << " " << aim.y << " " << aim.z;
      EXPECT_NEAR(hit->t, 1, 1e-10);
    }
  }
}

TEST(MeshMirror, DoubleDecidesWhichTriangleARayMeets) {
  for (int seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(static_cast<unsigned>(seed));
    const Mesh mesh = makeBumpyBall(random);
    const MeshMirror mirror = mirrorOf(mesh);
    const auto prepared = mirror.prepare();
    int asked = 0;
    for (int i = 0; i < 300; ++i) {
      const Triangle& t = mesh.triangles[static_cast<std::size_t>(
          random.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
      const Point onEdge = glm::mix(mesh.positions[t[0]], mesh.positions[t[1]], random.uniform(0.05, 0.95));
      const Point eye = 8.0 * random.direction();
      const Ray ray{eye, onEdge + 1e-9 * random.direction() - eye};  // nearer to the edge than float can tell
      const auto expected = nearestOfAll(mesh, ray);
      const auto hit = mirror.intersect(prepared, ray, 0);
      ASSERT_EQ(hit.has_value(), expected.has_value());
      if (!hit) continue;
      ++asked;
      EXPECT_NEAR(hit->t, expected->t, 1e-13);
      const Direction facet = glm::normalize(areaVector(mesh.positions, mesh.triangles[expected->triangle]));
      EXPECT_LT(glm::length(hit->facet - facet), 1e-12);
    }
    EXPECT_GT(asked, 100);
  }
}

TEST(MeshMirror, OfTwoSheetsThatFloatCannotTellApartTheNearerIsMet) {
  Mesh mesh;
  for (const double z : {0.0, 1e-9}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const Point& p : {Point(-1, -1, z), Point(1, -1, z), Point(0, 2, z)}) mesh.positions.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  const Shape shape = mirrorOf(mesh);
  const Ray down{{0.1, 0.2, 5}, {0, 0, -1}};
  const auto first = intersect(shape, down);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->t, 5 - 1e-9);
  const auto second = intersect(shape, down, first->t);
  ASSERT_TRUE(second) << "asked again, the next one";
  EXPECT_EQ(second->t, 5);
  EXPECT_FALSE(intersect(shape, down, second->t));
  EXPECT_EQ(intersect(shape, {{0.1, 0.2, -5}, {0, 0, 1}})->t, 5);
}

// Second order: a quarter of the error with half as large triangles. Flat normals would be off by half a triangle's turn.
TEST(MeshMirror, SmoothNormalsAreNearThoseOfTheSurface) {
  const auto gradient = [](const Point& p) { return glm::normalize(Vector(p.x, p.y, p.z / 4)); };
  double errors[2];
  for (int step = 0; step < 2; ++step) {
    SmoothMesh egg;
    egg.mesh = makeSphere(3, step == 0 ? 64 : 128);
    egg.mesh.positions =
        mapPoints(egg.mesh.positions, [](const Point& p) { return Point(p.x, p.y, 2 * p.z); });
    egg.normals = mapPoints(egg.mesh.positions, gradient);
    const Shape shape = mirrorOf(egg);
    errors[step] = 0;
    Random random(1);
    for (int i = 0; i < 2000; ++i) {
      const Point eye(0, -10, 2);
      const auto hit = intersect(shape, {eye, 2.0 * random.direction() - eye});
      ASSERT_TRUE(hit);
      errors[step] = std::max(errors[step], glm::length(hit->normal - gradient(hit->point)));
      EXPECT_NEAR(glm::length(hit->facet), 1, 1e-12);
    }
  }
  EXPECT_LT(errors[0], 2e-3);
  EXPECT_GT(errors[0], 1e-6);
  EXPECT_LT(errors[1], 0.4 * errors[0]);
}

TEST(MeshMirror, IsMovedTurnedAndScaledByItsPlacementAlone) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const MeshMirror mirror = mirrorOf(
        makeBumpyBall(random), {random.point(5), random.point(170), Vector(0.5) + glm::abs(random.point(2))});
    const Shape shape = mirror;
    const glm::dmat3 turn = rotationMatrix(random.point(170));
    const Point about = middleOf(shape), to = random.point(3);
    const Shape turned = mapShape(shape, {[&](const Point& p) { return about + turn * (p - about) + to; }});
    EXPECT_EQ(turned.as<MeshMirror>()->file, mirror.file);
    EXPECT_LT(glm::length(middleOf(turned) - about - to), 1e-9);
    const PointArray before = tessellate(shape).mesh.positions, after = tessellate(turned).mesh.positions;
    for (std::size_t p = 0; p < before.size(); ++p) {
      EXPECT_LT(glm::length(about + turn * (before[p] - about) + to - after[p]), 1e-8);
    }
    const Axes axes = axesOf(shape);
    const Vector factors(2, 1, 0.5);
    const auto scale = [&](const Point& p) {
      Point result = about;
      for (int axis = 0; axis < 3; ++axis)
        result += factors[axis] * glm::dot(p - about, axes[axis]) * axes[axis];
      return result;
    };
    const PointArray scaled = tessellate(mapShape(shape, {scale, factors})).mesh.positions;
    for (std::size_t p = 0; p < before.size(); ++p)
      EXPECT_LT(glm::length(scale(before[p]) - scaled[p]), 1e-8);
  }
}

// A placement turns normals, and stretches them the other way.
TEST(MeshMirror, PlacedNormalsArePerpendicularToThePlacedSurface) {
  SmoothMesh ball;
  ball.mesh = makeSphere(1, 256);
  ball.normals = ball.mesh.positions;
  const Shape shape = mirrorOf(ball, {{1, 2, 3}, {20, 30, 40}, {1, 2, 3}});
  Random random(3);
  for (int i = 0; i < 500; ++i) {
    const auto hit =
        intersect(shape, {{1, -20, 3}, Point(1, 2, 3) + 0.8 * random.direction() - Point(1, -20, 3)});
    ASSERT_TRUE(hit);
    EXPECT_GT(std::abs(glm::dot(hit->normal, hit->facet)), std::cos(radians(4)));
  }
}

TEST(MeshMirror, BoxAndCornersAreThoseOfThePlacedMesh) {
  const Shape shape = mirrorOf(makeBox({2, 4, 6}, 1), {{1, 1, 1}, {0, 0, 90}, {1, 1, 2}});
  const Box box = boxOf(shape);
  EXPECT_LT(glm::length(box.min - Point(-1, 0, -5)), 1e-12);
  EXPECT_LT(glm::length(box.max - Point(3, 2, 7)), 1e-12);
  EXPECT_LT(glm::length(middleOf(shape) - Point(1, 1, 1)), 1e-12);
  EXPECT_EQ(borderDistance(shape, box.min), 1);
}

TEST(MeshMirror, WhatIsWrongIsSaid) {
  const auto problemOf = [](SurfaceFile file) {
    return findProblem(Optic(OpticKind::mirror, MeshMirror{file, {}}));
  };
  const auto mesh = [](std::size_t triangles) {
    SmoothMesh surface;
    surface.mesh.triangles.resize(triangles);
    return std::make_shared<const SmoothMesh>(std::move(surface));
  };
  EXPECT_EQ(problemOf({}), "the mesh mirror cannot be used: expected the name of a mesh file.");
  EXPECT_EQ(problemOf({"a.obj", nullptr, {}}),
            "the mesh mirror cannot be used: its mesh file has not been read.");
  EXPECT_EQ(problemOf({"a.obj", nullptr, "a.obj: cannot open"}),
            "the mesh mirror cannot be used: a.obj: cannot open.");
  EXPECT_EQ(problemOf({"a.obj", mesh(0), {}}),
            "the mesh mirror cannot be used: expected a mesh with triangles, got one without.");
  EXPECT_EQ(
      problemOf({"a.obj", mesh(5'000'001), {}}),
      "the mesh mirror cannot be used: expected a mesh of at most 5000000 triangles, got 5000001; make it "
      "coarser.");
  const Shape nothing = MeshMirror{};
  EXPECT_FALSE(intersect(nothing, {{0, 0, 5}, {0, 0, -1}}));
  EXPECT_TRUE(isFinite(boxOf(nothing).centre()));
  EXPECT_TRUE(isFinite(extentOf(nothing).middle));
}

TEST(MeshMirror, KinksAreMeasured) {
  EXPECT_LT(largestKinkDegrees(withSmoothNormals(makeSphere(1, 128))), 3);
  EXPECT_GT(largestKinkDegrees(withSmoothNormals(makeSphere(1, 16))), 10);
  SmoothMesh inwards = withSmoothNormals(makeSphere(1, 128));
  inwards.normals = mapPoints(inwards.normals, [](const Vector& n) { return -n; });
  EXPECT_LT(largestKinkDegrees(inwards), 3) << "normals of the other side are as good";
}

}  // namespace
}  // namespace anamorph
