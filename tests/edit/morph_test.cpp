#include "edit/morph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>

#include "anamorphosis/vertex_ray.h"
#include "edit/edit_levels.h"
#include "geometry/shapes.h"
#include "pipeline/original.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

using namespace testing;

Sculpture makeTestSculpture(const Level& level, int segments) {
  const auto original = placeOriginal(makeBox({2, 1, 1}, segments), false, level.original.placement);
  DeformInput input = makeDeformInput(level, original);
  input.tolerancePixels = 0;
  return makeSculpture(input);
}

TEST(MorphPoints, GoAtOneSpeedAlongTheVertexRays) {
  std::size_t mapped = 0, unmapped = 0;
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 100; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = makeRandomLevel(kind, random);
      level.sculpture.depthScale = random.uniform(0.2, 2);
      const Sculpture sculpture = makeTestSculpture(level, 4);
      const auto at = [&](double t) { return morphPoints(sculpture, makeVertexMap(level), t, 2); };
      EXPECT_EQ(at(0), sculpture.original);
      EXPECT_EQ(at(1), sculpture.mesh.positions);
      EXPECT_EQ(at(-1), sculpture.original);
      EXPECT_EQ(at(2), sculpture.mesh.positions);
      const double t = random.uniform(0, 1);
      const PointArray points = at(t);
      double longest = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (sculpture.status[i] != PathStatus::mapped) continue;
        const VertexRay ray = makeVertexRay(makeVertexMap(level), sculpture.original[i]);
        longest = std::max(longest, ray.distance + glm::length(ray.sculpture - ray.legs.back().start));
      }
      ASSERT_EQ(points.size(), sculpture.original.size());
      for (std::size_t i = 0; i < points.size(); ++i) {
        if (sculpture.status[i] != PathStatus::mapped) {
          ++unmapped;
          EXPECT_EQ(points[i], sculpture.original[i]);
          continue;
        }
        ++mapped;
        const VertexRay ray = makeVertexRay(makeVertexMap(level), sculpture.original[i]);
        const double in = ray.distance, out = glm::length(ray.sculpture - ray.legs.back().start),
                     gone = std::min(t * longest, in + out);
        const Point wanted = gone < in
                                 ? ray.original + gone * glm::normalize(ray.legs.back().start - ray.original)
                                 : ray.legs.back().start + (gone - in) * ray.legs.back().direction;
        EXPECT_LT(glm::length(points[i] - wanted), 1e-9 * (1 + in + out));
      }
    }
  }
  EXPECT_GT(mapped, 5000u);
  EXPECT_GT(unmapped, 100u);
}

TEST(MorphPoints, NeverLieFlatInAPlaneMirror) {
  for (const double depthScale : {0.5, 1.0, 2.0}) {
    Level level;  // a box behind a mirror in the plane y = 0
    level.sculpture.depthScale = depthScale;
    const Sculpture sculpture = makeTestSculpture(level, 4);
    for (int percent = 0; percent <= 100; ++percent) {
      const PointArray points = morphPoints(sculpture, makeVertexMap(level), 0.01 * percent);
      const Vector size = boundingBox(points).size();
      EXPECT_GT(size.y, 0.1 * std::min(1.0, depthScale)) << percent << " %, k = " << depthScale;
    }
  }
}

TEST(MorphPoints, AreTheSameForEveryNumberOfThreads) {
  Random random(1);
  const Level level = makeRandomLevel(ShapeKind::cylinder, random);
  const Sculpture sculpture = makeTestSculpture(level, 60);
  const PointArray one = morphPoints(sculpture, makeVertexMap(level), 0.4, 1);
  EXPECT_EQ(morphPoints(sculpture, makeVertexMap(level), 0.4, 4), one);
}

TEST(MorphPoints, KeepUpWithASlider) {
  const Level level;
  const Sculpture sculpture = makeTestSculpture(level, 90);  // 49 k vertices
  ASSERT_GT(sculpture.original.size(), 48000u);
  double best = 1e9;
  for (int i = 0; i < 5; ++i) {
    const auto start = std::chrono::steady_clock::now();
    morphPoints(sculpture, makeVertexMap(level), 0.3 + 0.1 * i, 2);
    best = std::min(
        best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  RecordProperty("milliseconds", std::to_string(best));
  EXPECT_LT(best, 50) << "far above what it takes, for loaded machines";
}

TEST(MorphPoints, AnotherMirrorDoesNoHarm) {
  const Sculpture sculpture = makeTestSculpture({}, 4);
  for (const Level& level : makeAbsurdLevels()) {
    for (const Point& eye : {level.camera.eye, sculpture.original[0]}) {
      const PointArray points = morphPoints(sculpture, {level.optic, eye, 1, {}}, 0.5);
      for (std::size_t i = 0; i < points.size(); ++i) EXPECT_TRUE(isFinite(points[i]));
    }
  }
  EXPECT_TRUE(morphPoints({}, {}, 0.5).empty());
}

}  // namespace
}  // namespace anamorph
