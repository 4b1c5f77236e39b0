// The shaders' leaf functions, compiled as C++, say what the core says, on many random rays and without OpenGL.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "leaf_functions.h"
#include "optics/shape_table.h"
#include "random_scene.h"
#include "raytrace/image.h"
#include "raytrace/scene_hit.h"
#include "raytrace/shading.h"

namespace anamorph {
namespace {

using glm::vec3;
using glm::vec4;
using testing::Random;

constexpr int rayCount = 100'000, raysAScene = 100;

// Both sides of the comparison get the same numbers: what fits a float.
Vector rounded(const Vector& v) {
  return Vector(vec3(v));
}
Ray randomRay(const Point& from, const Point& to) {
  return {rounded(from), rounded(glm::normalize(to - from))};
}

using Distance = std::function<std::optional<double>(const Ray&)>;  // nothing: no hit

/// Whether a ray is far enough from a tangent or a border that both sides must agree: its neighbours do.
bool isClear(const Ray& ray, const Distance& core, double size) {
  const auto here = core(ray);
  const Frame frame = makeFrame(ray.direction, {0, 0, 1});
  for (const Vector& side : {frame.right, -frame.right, frame.up, -frame.up}) {
    const auto there = core({ray.origin + 2e-3 * size * side, ray.direction});
    if (here.has_value() != there.has_value()) return false;
    if (here && std::abs(*here - *there) > 0.02 * size) return false;
  }
  return true;
}

struct Agreement {
  int hits = 0, clear = 0, rays = 0;

  void add(const Ray& ray, const Distance& core, double leaf, double size) {
    ++rays;
    if (!isClear(ray, core, size)) return;
    ++clear;
    const auto expected = core(ray);
    hits += expected.has_value();
    EXPECT_EQ(expected.has_value(), leaf > 0) << expected.value_or(-1) << " and " << leaf;
    if (expected && leaf > 0) {
      EXPECT_NEAR(leaf, *expected, 1e-4 * std::max(*expected, 0.01 * size));
    }
  }
  void expectMany() const {
    EXPECT_GE(rays, rayCount);
    EXPECT_GT(clear, 0.85 * rays);
    EXPECT_GT(hits, 0.2 * rays);
    EXPECT_LT(hits, 0.95 * rays);
  }
};

// ---- Shapes

struct ShapeFunctions {
  const char* name;
  testing::ShapeKind kind;
  float (*intersectShape)(vec3, vec3, vec4*, float, float);
  vec3 (*shapeNormal)(vec3, vec4*);
  float (*borderDistance)(vec3, vec4*);
};

// As the scene block has it.
std::array<vec4, shapeVectors> packed(const Shape& shape) {
  const PackedShape numbers = shape->packed(Point(0));
  std::array<vec4, shapeVectors> data;
  std::copy(numbers.begin(), numbers.end(), data.begin());
  return data;
}

class ShapeLeaf : public ::testing::TestWithParam<ShapeFunctions> {};

TEST_P(ShapeLeaf, SaysWhatTheShapeSays) {
  const ShapeFunctions& leaf = GetParam();
  Random random(17);
  Agreement agreement, second;  // what is met first, and what beyond that: a place may be cut away
  while (agreement.rays < rayCount) {
    const testing::RandomScene scene = makeRandomScene(leaf.kind, random);
    const Shape& shape = scene.optic.shape();
    const Box box = boundingBox(tessellate(shape).mesh.positions);
    const double size = box.diagonal();
    auto data = packed(shape);
    const Distance core = [&](const Ray& ray) -> std::optional<double> {
      const auto hit = intersect(shape, ray);
      return hit ? std::optional(hit->t) : std::nullopt;
    };
    for (int i = 0; i < raysAScene; ++i) {
      const Point aim = box.centre() + random.uniform(0, 0.7) * size * random.direction();
      const Ray ray = randomRay(scene.eye + random.point(2), aim);
      const vec3 origin(ray.origin), direction(ray.direction);
      const float t = leaf.intersectShape(origin, direction, data.data(), 0, 1e30f);
      agreement.add(ray, core, t, size);
      if (!(t > 0) || !isClear(ray, core, size)) continue;
      EXPECT_LT(leaf.intersectShape(origin, direction, data.data(), 0, 0.999f * t), 0) << "not before tMax";
      const SurfaceHit hit = *intersect(shape, ray);
      const Distance coreAgain = [&](const Ray& r) -> std::optional<double> {
        const auto first = intersect(shape, r);
        const auto again = first ? intersect(shape, r, first->t + 0.01 * size) : std::nullopt;
        return again ? std::optional(again->t) : std::nullopt;
      };
      const float beyond = t + 0.01f * static_cast<float>(size);
      second.add(ray, coreAgain, leaf.intersectShape(origin, direction, data.data(), beyond, 1e30f), size);
      const Vector normal(leaf.shapeNormal(vec3(hit.point), data.data()));
      EXPECT_NEAR(std::abs(glm::dot(normal, hit.normal)), 1, 1e-5);
      const double cosine = std::abs(glm::dot(ray.direction, hit.normal));
      const float border = leaf.borderDistance(vec3(hit.point), data.data());
      EXPECT_NEAR(glsl::mirrorRim(border, static_cast<float>(cosine)), mirrorRim(shape, hit.point, cosine),
                  2e-3);
    }
  }
  agreement.expectMany();
  EXPECT_GT(second.clear, 0.85 * second.rays);
}

TEST_P(ShapeLeaf, ShinesAtItsBorder) {
  const ShapeFunctions& leaf = GetParam();
  Random random(18);
  for (int i = 0; i < 200; ++i) {
    const testing::RandomScene scene = makeRandomScene(leaf.kind, random);
    auto data = packed(scene.optic.shape());
    const PointArray points =
        tessellate(scene.optic.shape()).mesh.positions;  // those of plane and cylinder lie on it
    for (std::size_t p = 0; p < points.size(); ++p) {
      const float border = leaf.borderDistance(vec3(points[p]), data.data());
      EXPECT_NEAR(border, borderDistance(scene.optic.shape(), points[p]), 1e-4);
    }
  }
}

#define SHAPE_FUNCTIONS(name)                                                             \
  ShapeFunctions {                                                                        \
#name, testing::ShapeKind::name, glsl::name::intersectShape, glsl::name::shapeNormal, \
        glsl::name::borderDistance                                                        \
  }
const ShapeFunctions allShapes[] = {SHAPE_FUNCTIONS(plane),     SHAPE_FUNCTIONS(cylinder),
                                    SHAPE_FUNCTIONS(sphere),    SHAPE_FUNCTIONS(cone),
                                    SHAPE_FUNCTIONS(ellipsoid), SHAPE_FUNCTIONS(paraboloid)};

INSTANTIATE_TEST_SUITE_P(Shapes, ShapeLeaf, ::testing::ValuesIn(allShapes),
                         [](const auto& shape) { return std::string(shape.param.name); });

TEST(Leaf, EveryShapeIsCompared) {
  std::set<std::string> compared, known;
  for (const ShapeFunctions& shape : allShapes) compared.insert(shape.name);
  for (const ShapeType& type : shapeTypes()) known.insert(shaderOf(type.standard));
  known.erase(tessellatedShader);  // triangles are traced through textures: parity_test.cpp
  EXPECT_EQ(compared, known);
}

// ---- Triangles and boxes

TEST(Leaf, TrianglesAreMetWhereTheTreeMeetsThem) {
  Random random(19);
  Agreement agreement;
  while (agreement.rays < rayCount) {
    Mesh mesh;
    const Point middle = random.point(3);
    for (int i = 0; i < 3; ++i) mesh.positions.push_back(rounded(middle + random.point(2)));
    mesh.triangles = {{0, 1, 2}};
    const Point a = mesh.positions[0], b = mesh.positions[1], c = mesh.positions[2];
    const double size = glm::length(b - a) + glm::length(c - a);
    const double height = glm::length(glm::cross(b - a, c - a)) / size;
    if (height < 0.1) continue;
    const Bvh bvh(mesh.positions, mesh.triangles);
    const Distance core = [&](const Ray& ray) -> std::optional<double> {
      BvhHit hit;
      return bvh.closestHit(ray, hit) ? std::optional(hit.t) : std::nullopt;
    };
    for (int i = 0; i < raysAScene; ++i) {
      const Point at = a + random.uniform(-0.3, 1) * (b - a) + random.uniform(-0.3, 1) * (c - a);
      const Ray ray = randomRay(random.point(30), at);
      if (std::abs(glm::dot(ray.direction, glm::normalize(glm::cross(b - a, c - a)))) < 0.05) continue;
      const glsl::FloatRay r =
          glsl::makeFloatRay(vec3(ray.origin), vec3(ray.direction), vec3(bvh.centre()), 4);
      const vec3 centre(bvh.centre());
      const glsl::TriangleHit hit =
          glsl::passesThrough(r, vec3(a) - centre, vec3(b) - centre, vec3(c) - centre);
      agreement.add(ray, core, hit.met ? hit.t : -1, size);
      BvhHit expected;
      if (!hit.met || !isClear(ray, core, size) || !bvh.closestHit(ray, expected)) continue;
      EXPECT_NEAR(hit.u, expected.u, 2e-3);
      EXPECT_NEAR(hit.v, expected.v, 2e-3);
      const glsl::TriangleHit seen =
          glsl::intersectTriangle(vec3(ray.origin), vec3(ray.direction), vec3(a), vec3(b), vec3(c));
      EXPECT_TRUE(seen.met);
      EXPECT_NEAR(seen.t, expected.t, 1e-4 * std::max(expected.t, 1.0));
      EXPECT_NEAR(seen.u, expected.u, 2e-3);
    }
  }
  agreement.expectMany();
}

TEST(Leaf, SeenTrianglesAreMetNearbyWhenJustMissed) {
  Random random(20);
  for (int i = 0; i < 10'000; ++i) {
    const Point a = random.point(2), b = random.point(2), c = random.point(2), origin = random.point(20);
    if (glm::length(glm::cross(b - a, c - a)) < 0.5) continue;
    const Ray ray = randomRay(origin, a + 1e-3 * random.point(1));
    const glsl::TriangleHit hit =
        glsl::intersectTriangle(vec3(origin), vec3(ray.direction), vec3(a), vec3(b), vec3(c));
    EXPECT_GE(hit.u, 0);
    EXPECT_GE(hit.v, 0);
    EXPECT_LE(hit.u + hit.v, 1 + 1e-6);
  }
}

TEST(Leaf, BoxesAreEnteredWhereTheirSidesAre) {
  Random random(21);
  Agreement agreement;
  while (agreement.rays < rayCount) {
    Box box;
    box.extend(rounded(random.point(3)));
    box.extend(rounded(random.point(3)));
    const double size = box.diagonal();
    const Distance core = [&](const Ray& ray) -> std::optional<double> {
      double first = 0, last = std::numeric_limits<double>::infinity();
      for (int axis = 0; axis < 3; ++axis) {
        const double p = (box.min[axis] - ray.origin[axis]) / ray.direction[axis],
                     q = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
        first = std::max(first, std::min(p, q));
        last = std::min(last, std::max(p, q));
      }
      return first <= last ? std::optional(first) : std::nullopt;
    };
    for (int i = 0; i < raysAScene; ++i) {
      const Ray ray = randomRay(random.point(12), box.centre() + 0.5 * size * random.direction());
      const vec3 inverse = 1.0f / glsl::withoutZero(vec3(ray.direction));
      const float t = glsl::enterBox(vec3(ray.origin), inverse, vec3(box.min), vec3(box.max), 0, 1e30f);
      const auto expected = core(ray);
      if (expected && *expected == 0) {  // it starts inside
        ++agreement.rays;
        EXPECT_EQ(t, 0);
      } else {
        agreement.add(ray, core, t < glsl::missed ? t : -1, size);
      }
    }
  }
  agreement.expectMany();
}

// ---- Ground and lights

TEST(Leaf, TheGroundIsMetAndFadesAlike) {
  Random random(22);
  Agreement agreement;
  double worst = 0;
  while (agreement.rays < rayCount) {
    SceneInput input;
    input.ground = Ground{};
    input.ground->height = static_cast<float>(random.uniform(-3, 3));
    RenderScene scene;
    scene.input = input;
    scene.radius = static_cast<float>(random.uniform(0.5, 20));  // about the origin, as the shaders have it
    const Distance core = [&](const Ray& ray) -> std::optional<double> {
      const auto hit = findHit(scene, ray);
      return hit ? std::optional(hit->t) : std::nullopt;
    };
    for (int i = 0; i < raysAScene; ++i) {
      const Point from = scene.radius * (Point(0, 0, 1) + random.point(2));
      const Ray ray =
          randomRay(from, Point(0, 0, input.ground->height) + 4 * scene.radius * random.direction());
      if (std::abs(ray.direction.z) < 0.02) {
        ++agreement.rays;
        continue;
      }
      const glsl::GroundHit hit = glsl::intersectGround(vec3(ray.origin), vec3(ray.direction),
                                                        static_cast<float>(input.ground->height),
                                                        static_cast<float>(scene.radius), 1e30f);
      agreement.add(ray, core, hit.met ? hit.t : -1, 0.1 * scene.radius);
      if (const auto expected = findHit(scene, ray); expected && hit.met)
        worst = std::max(worst, std::abs(hit.fade - expected->groundFade));
    }
  }
  EXPECT_LT(worst, 1e-3);
  EXPECT_GT(agreement.hits, 0.1 * agreement.rays);
}

TEST(Leaf, MarkersAreSpheresSeenFromOutside) {
  Random random(23);
  Agreement agreement;
  while (agreement.rays < rayCount) {
    const SphereMirror ball{rounded(random.point(5)), static_cast<float>(random.uniform(0.1, 2))};
    const Distance core = [&](const Ray& ray) -> std::optional<double> {
      const auto hit = intersect(ball, ray);
      return hit ? std::optional(hit->t) : std::nullopt;
    };
    for (int i = 0; i < raysAScene; ++i) {
      const Point from = ball.centre + random.uniform(1.2, 10) * ball.radius * random.direction();
      const Ray ray = randomRay(from, ball.centre + 1.3 * ball.radius * random.direction());
      const float t = glsl::intersectMarker(vec3(ray.origin), vec3(ray.direction), vec3(ball.centre),
                                            static_cast<float>(ball.radius), 1e30f);
      agreement.add(ray, core, t, ball.radius);
    }
  }
  agreement.expectMany();
}

// ---- Colours

glsl::Material packed(const Material& m) {
  glsl::Material material;
  material.color = vec3(m.color);
  material.ambient = static_cast<float>(m.ambient);
  material.diffuse = static_cast<float>(m.diffuse);
  material.specular = static_cast<float>(m.specular);
  material.shininess = static_cast<float>(m.shininess);
  return material;
}

Material randomMaterial(Random& random) {
  Material material;
  material.color = glm::abs(random.point(1));
  material.ambient = random.uniform(0, 1);
  material.diffuse = random.uniform(0, 1);
  material.specular = random.uniform(0, 1);
  material.shininess = random.integer(0, 3) == 0 ? 0 : random.uniform(0, 100);
  return material;
}

double largest(const Color& a, const vec3& b) {
  const Color d = glm::abs(a - Color(b));
  return std::max({d.x, d.y, d.z});
}

TEST(Leaf, SurfacesAnswerLightAlike) {
  Random random(24);
  for (int i = 0; i < rayCount; ++i) {
    const Material material = randomMaterial(random);
    SceneHit hit;
    hit.faceNormal = random.direction();
    hit.normal = glm::normalize(hit.faceNormal + random.point(0.5));
    if (glm::dot(hit.normal, hit.faceNormal) < 0.1) continue;
    const Direction toLight = random.direction(), toEye = random.direction();
    if (std::abs(glm::dot(toLight, hit.normal)) < 0.02) continue;  // the terminator: a step
    const Color expected = phongResponse(material, hit, toLight, toEye);
    const vec3 leaf = glsl::phongResponse(packed(material), vec3(hit.faceNormal), vec3(hit.normal),
                                          vec3(toLight), vec3(toEye));
    const double highlight = glm::dot(2 * glm::dot(hit.normal, toLight) * hit.normal - toLight, toEye);
    if (material.shininess < 1 && std::abs(highlight) < 1e-3) continue;  // as steep as a step
    EXPECT_LT(largest(expected, leaf), 1e-4);
  }
}

TEST(Leaf, TheTerminatorFactorIsNeverMoreThanOne) {
  Random random(25);
  for (int i = 0; i < rayCount; ++i) {
    const vec3 face(random.direction()), normal(random.direction()), toLight(random.direction());
    const float cosine = glm::dot(normal, toLight);
    if (!(cosine > 0) || !(glm::dot(face, normal) > 0)) continue;
    const float factor = glsl::terminatorFactor(face, normal, toLight, cosine);
    EXPECT_GE(factor, 0);
    EXPECT_LE(factor, 1);
    if (glm::dot(face, toLight) <= 0) {
      EXPECT_EQ(factor, 0);
    }
  }
}

TEST(Leaf, TheGroundsGridIsDrawnAlike) {
  Random random(26);
  for (int i = 0; i < rayCount; ++i) {
    Ground ground;
    ground.material = randomMaterial(random);
    ground.gridSpacing = i % 10 == 0 ? 0 : random.uniform(0.1, 4);
    const Point point = rounded(random.point(8));
    const double footprint = std::exp(random.uniform(-9, 2));
    const Material expected = groundMaterial(ground, point, footprint);
    const glsl::Material leaf = glsl::groundMaterial(
        packed(ground.material), static_cast<float>(ground.gridSpacing), static_cast<float>(point.x),
        static_cast<float>(point.y), static_cast<float>(footprint));
    // The edge of a line is steep: a pixel's width there is a quarter of the line at least.
    EXPECT_LT(largest(expected.color, leaf.color), 2e-3);
  }
  EXPECT_EQ(glsl::lineCoverage(0.5f, 0.018f, 0.001f), 0);
  EXPECT_EQ(glsl::lineCoverage(3.0f, 0.018f, 0.001f), 1);
}

TEST(Leaf, BackgroundAndToneCurveAreTheSame) {
  Random random(27);
  const Background background{glm::abs(random.point(1)), glm::abs(random.point(1))};
  for (int i = 0; i < rayCount; ++i) {
    const Direction direction = random.direction();
    const vec3 leaf = glsl::backgroundColor(vec3(background.bottom), vec3(background.top), vec3(direction));
    EXPECT_LT(largest(backgroundColor(background, direction), leaf), 1e-6);
    const float light = static_cast<float>(random.uniform(-0.1, 4));
    EXPECT_NEAR(glsl::toDisplay(light), toDisplay(light), 1e-6);
  }
}

}  // namespace
}  // namespace anamorph
