#include "raytrace/tracer.h"

#include <gtest/gtest.h>

#include "base/check.h"
#include "raytrace/shading.h"
#include "raytrace/test_scenes.h"
#include "shapes.h"

namespace anamorph::test {
namespace {

const Material paint{{0.5, 0.25, 1}, 0.3, 0.6, 0.2, 10};

void expectColor(const Color& color, const Color& expected, double tolerance = 1e-12) {
  EXPECT_LE(glm::length(color - expected), tolerance)
      << "got " << color.x << ' ' << color.y << ' ' << color.z << ", expected " << expected.x << ' '
      << expected.y << ' ' << expected.z;
}

Ray rayBetween(const Point& from, const Point& to) {
  return {from, glm::normalize(to - from)};
}

// A painted floor around the origin, a light 5 above it.
SceneInput litFloor() {
  SceneInput input;
  input.surfaces.push_back(makeSurface("floor", makeFloor(10, 0), paint));
  input.lights.push_back({{0, 0, 5}, {1, 0.5, 0.25}, 0.8});
  return input;
}

// Between floor and light.
MeshSurface parasol() {
  return makeSurface("parasol", makeFloor(0.5, 2), paint);
}

TEST(TraceColor, ARayIntoNothingBringsTheBackground) {
  SceneInput input;
  input.background = {{1, 0, 0}, {0, 0, 1}};
  expectColor(traceColor(buildScene(input), {{0, 0, 0}, {0, 0.6, 0.8}}, {}), {0.9, 0, 0.1});
}

TEST(TraceColor, ALitFloorShowsAmbientDiffuseAndHighlight) {
  const RenderScene scene = buildScene(litFloor());
  const Color light = 0.8 * Color(1, 0.5, 0.25);
  expectColor(traceColor(scene, rayBetween({0, 0, 3}, {0, 0, 0}), {}),
              paint.color * (Color(0.3) + 0.6 * light) + 0.2 * light);
  // Seen far from the highlight; the light stands at 3-4-5.
  const double highlight =
      std::pow(glm::dot(glm::normalize(Vector(4, 0, 5)), glm::normalize(Vector(4, 3, 5))), 10);
  const double cosine = 5 / std::sqrt(41.0);
  expectColor(traceColor(scene, rayBetween({8, 3, 5}, {4, 0, 0}), {}),
              paint.color * (Color(0.3) + 0.6 * cosine * light) + 0.2 * highlight * light, 1e-9);
}

TEST(TraceColor, SeenFromBelowALightAboveGivesNothing) {
  expectColor(traceColor(buildScene(litFloor()), rayBetween({0, 0, -3}, {0, 0, 0}), {}), 0.3 * paint.color);
}

TEST(TraceColor, LightsAdd) {
  SceneInput one = litFloor(), two = litFloor(), both = litFloor();
  two.lights[0] = {{-3, 1, 4}, {0.2, 1, 1}, 0.5};
  both.lights.push_back(two.lights[0]);
  const auto seen = [](const SceneInput& input) {
    return traceColor(buildScene(input), rayBetween({2, -2, 3}, {1, 1, 0}), {});
  };
  expectColor(seen(both), seen(one) + seen(two) - 0.3 * paint.color);
}

TEST(TraceColor, ShadowsTakeTheLightAway) {
  SceneInput input = litFloor();
  input.surfaces.push_back(parasol());
  const RenderScene scene = buildScene(input), open = buildScene(litFloor());
  const Ray ray = rayBetween({3, 0, 1}, {0.2, 0.3, 0});
  expectColor(traceColor(scene, ray, {}), 0.3 * paint.color);
  TraceOptions noShadows;
  noShadows.shadows = false;
  expectColor(traceColor(scene, ray, noShadows), traceColor(open, ray, {}), 1e-9);
  const Ray beside = rayBetween({3, 0, 1}, {1.2, 0.3, 0});
  EXPECT_EQ(traceColor(scene, beside, {}), traceColor(open, beside, {})) << "outside the shadow";
}

TEST(TraceColor, TheMirrorThrowsAShadow) {
  SceneInput input = litFloor();
  input.optic = makeMirror(SphereMirror{{0, 0, 2.5}, 1});
  expectColor(traceColor(buildScene(input), rayBetween({3, 0, 1}, {0.2, 0.3, 0}), {}), 0.3 * paint.color);
}

TEST(TraceColor, AMirrorShowsTheBackgroundOfTheMirroredDirection) {
  SceneInput input;
  input.background = {{1, 0, 0}, {0, 0, 1}};
  input.optic = makeMirror(PlaneMirror{{Point(-9, -9, 0), Point(9, -9, 0), Point(9, 9, 0), Point(-9, 9, 0)}});
  const Color expected = 0.8 * Color(0.9, 0.95, 1) * Color(0.9, 0, 0.1);
  for (const int depth : {0, 1, 3}) {
    TraceOptions options;
    options.maxDepth = depth;
    expectColor(traceColor(buildScene(input), {{0, 0, 3}, {0.6, 0, -0.8}}, options), expected);
  }
}

TEST(TraceColor, APlaneMirrorShowsTheMirroredScene) {
  // The mirror fills y = 0 and everything is in front of it; the other scene has everything mirrored and no
  // mirror.
  const auto mirrored = [](const Point& p) { return Point(p.x, -p.y, p.z); };
  SceneInput behind;
  behind.surfaces.push_back(makeSurface("box", makeCuboid({-1, -3, 0.4}, {1, -2, 1.2}), paint));
  behind.surfaces.push_back(makeSurface("floor", makeFloor(8, 0), paint));
  behind.lights.push_back({{2, -4, 5}, {1, 0.9, 0.8}, 0.8});
  SceneInput mirrorScene = behind;
  mirrorScene.optic =
      makeMirror(PlaneMirror{{Point(-90, 0, -90), Point(90, 0, -90), Point(90, 0, 90), Point(-90, 0, 90)}});
  for (MeshSurface& surface : behind.surfaces) {
    Mesh mesh{mapPoints(surface.mesh->positions, mirrored), surface.mesh->triangles};
    surface = makeSurface(surface.name, mesh, surface.material);
  }
  behind.lights[0].position = mirrored(behind.lights[0].position);

  const RenderScene scene = buildScene(mirrorScene), reference = buildScene(behind);
  int different = 0, seen = 0;
  for (double z = 0.01; z < 3; z += 0.037) {
    for (double x = -2; x < 2; x += 0.037) {
      const Ray ray = rayBetween({0.3, -1.5, 1.7}, {x, 0, z});
      const Color expected = 0.8 * Color(0.9, 0.95, 1) * traceColor(reference, ray, {});
      different += glm::length(traceColor(scene, ray, {}) - expected) > 1e-4;
      ++seen;
    }
  }
  EXPECT_LE(different, seen / 500) << "only at edges of objects and shadows";
}

TEST(TraceColor, LooksThroughAPeriscopeAsOverTheEdge) {
  SceneInput direct;
  direct.surfaces.push_back(makeSurface("box", makeCuboid({-1, 6, 4}, {1, 8, 6}), paint));
  direct.lights.push_back({{3, -2, 9}, {1, 0.9, 0.8}, 0.8});
  SceneInput bent = direct;
  bent.optic = OpticSurface{makePeriscope(), Color(1), 1};
  const RenderScene scene = buildScene(bent), reference = buildScene(direct);
  int seen = 0;
  for (double x = -0.5; x <= 0.5; x += 0.1) {
    const Ray ray{{x, -5, 0}, {0, 1, 0}}, over{{x, 0.5, 5}, {0, 1, 0}};
    const Color wanted = traceColor(reference, over, {});
    EXPECT_LT(glm::length(traceColor(scene, ray, {}) - wanted), 1e-4) << x;
    seen += glm::length(wanted) > 0.01;
  }
  EXPECT_GT(seen, 5);
}

TEST(TraceColor, DepthLimitsTheReflectionsInARow) {
  // Inside a mirror sphere a ray never ends.
  SceneInput input;
  input.optic = OpticSurface{Optic{OpticKind::mirror, SphereMirror{{0, 0, 0}, 2}}, Color(1), 0.5};
  input.background = {Color(1), Color(1)};
  const RenderScene scene = buildScene(input);
  const Ray ray = rayBetween({0.1, 0.2, -0.3}, {1, -0.4, 0.7});
  for (int depth = 0; depth <= maxTraceDepth; ++depth) {
    TraceOptions options;
    options.maxDepth = depth;
    expectColor(traceColor(scene, ray, options), Color(std::pow(0.5, depth + 1)));
    EXPECT_EQ(tracePath(scene, ray, options).segments.size(), static_cast<std::size_t>(depth) + 1);
  }
  for (const int depth : {-1, maxTraceDepth + 1}) {
    TraceOptions options;
    options.maxDepth = depth;
    EXPECT_THROW(traceColor(scene, ray, options), ProgrammingError);
  }
}

TEST(TraceColor, TheGroundFadesIntoTheBackgroundWithoutAHorizon) {
  SceneInput input;
  input.surfaces.push_back(makeSurface("box", makeCuboid({-1, -1, 0}, {1, 1, 1}), paint));
  input.ground = Ground{};
  input.ground->gridSpacing = 0;
  input.lights.push_back({{0, 0, 9}, Color(1), 1});
  const RenderScene scene = buildScene(input);
  Color last = traceColor(scene, rayBetween({0, 0, 2}, {3, 0, 0}), {});
  for (double angle = -33; angle < 20; angle += 0.02) {
    const Color now =
        traceColor(scene, {{0, 0, 2}, {std::cos(radians(angle)), 0, std::sin(radians(angle))}}, {});
    ASSERT_LT(glm::length(now - last), 0.01) << "a line at " << angle << " degrees";
    last = now;
  }
}

TEST(TraceColor, ConvexObjectsDoNotShadeThemselvesAtAnyScale) {
  for (const double scale : {1e-3, 1e-1, 1.0, 1e3, 1e5}) {
    SceneInput input;
    input.surfaces.push_back(makeSurface("box", makeCuboid({-1, -2, 0.5}, {2, 1, 1.5}), paint));
    input.lights = {{{-3, -5, 4}, Color(1), 0.6}, {{5, -4, 7}, Color(1), 0.6}};
    const RenderScene scene = buildScene(scaled(input, scale));
    TraceOptions noShadows;
    noShadows.shadows = false;
    for (double x = -1.2; x < 2.2; x += 0.021) {
      for (double z = 0.3; z < 1.8; z += 0.023) {
        const Ray ray = rayBetween(scale * Point(-2, -8, 4), scale * Point(x, -1, z));
        ASSERT_EQ(traceColor(scene, ray, {}), traceColor(scene, ray, noShadows))
            << x << ' ' << z << ", scale " << scale;
      }
    }
  }
}

TEST(TraceColor, NoLightLeaksIntoAClosedBoxAtAnyScale) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  for (const double scale : {1e-3, 1.0, 1e5}) {
    SceneInput input;
    input.surfaces.push_back(makeSurface("box", makeCuboid({-1, -1, -1}, {1, 1, 1}), paint));
    input.lights = {{{-3, -5, 4}, Color(1), 1}, {{1.01, 0, 0}, Color(1), 1}};
    const RenderScene scene = buildScene(scaled(input, scale));
    for (int i = 0; i < 4000; ++i) {
      const Vector towards(coordinate(random), coordinate(random), coordinate(random));
      const Ray ray{0.9 * scale * Vector(coordinate(random), coordinate(random), coordinate(random)),
                    glm::normalize(towards)};
      ASSERT_EQ(traceColor(scene, ray, {}), paint.ambient * paint.color)
          << "seed 11, ray " << i << ", scale " << scale;
    }
  }
}

}  // namespace
}  // namespace anamorph::test
