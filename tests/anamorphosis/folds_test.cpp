// A sculpture across the place where the rays of a hollow mirror cross: what is folded, and that nothing else is.

#include "anamorphosis/folds.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "anamorphosis/ray_bundle.h"
#include "anamorphosis/sculpture.h"
#include "geometry/shapes.h"
#include "random_scene.h"

namespace anamorph {
namespace {

using testing::Random;

// The dish of method-optics: a cut of a ball of radius 14, hollow to the eye, with a box behind it.
struct Dish {
  Dish() {
    Shape dish = SphereMirror{{0, -12, 4}, 14};
    dish.clipBy({{{0, -1, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 0, 1}}, {{0, 0, 8.5}, {0, 0, -1}}});
    input.map.optic.shape() = dish;
    input.map.eye = {0, -10.7, 8};
    input.camera.eye = input.map.eye;
    input.camera.target = {0, 5.9, 1.6};
    Mesh box = makeBox({6, 2, 2}, 8);
    box.positions = mapPoints(box.positions, [](const Point& p) { return Point(0, 5.9, 1.6) + 1.05 * p; });
    input.original = std::make_shared<const Mesh>(std::move(box));
  }
  Sculpture at(double scale, double offset) {
    input.map.depthScale = scale;
    input.map.depthOffset = offset;
    return makeSculpture(input, 2);
  }
  DeformInput input;
};

TEST(Folds, AreNoneBeforeTheFocusAndNoneBeyond) {
  Dish dish;
  for (const auto& [scale, offset] : {std::pair{0.9, 0.0}, {0.9, 30.0}}) {
    const Sculpture sculpture = dish.at(scale, offset);
    EXPECT_EQ(sculpture.folded.triangles, 0u) << offset;
    EXPECT_EQ(sculpture.folded.share, 0);
    EXPECT_GT(signedVolume(sculpture.mesh), 0) << "outside stays outside (fact G9)";
  }
}

TEST(Folds, AcrossTheFocusAreLeftOutAndCounted) {
  Dish dish;
  const Sculpture whole = dish.at(0.9, 0);
  const auto bundle = bundleAround(dish.input.map, {0, 5.9, 1.6});
  ASSERT_TRUE(bundle && !bundle->foci().empty());
  const double middle = bundle->distance(), focus = bundle->foci().front();
  const Sculpture folded = dish.at(0.9, focus - middle);
  EXPECT_GT(folded.folded.triangles, 0u);
  EXPECT_GT(folded.folded.share, 0.02);
  EXPECT_LE(folded.folded.share, 0.5);
  EXPECT_GT(folded.folded.foci.nearest, 0.5 * focus);
  EXPECT_LT(folded.folded.foci.nearest, 1.5 * focus);
  EXPECT_LT(folded.mesh.triangles.size() + folded.folded.triangles, 30 * whole.mesh.triangles.size());
}

// What is folded is told by the exact spread at the triangle's middle, and the same for every number of threads.
TEST(Folds, AgreeWithTheRaysAroundATrianglesMiddle) {
  std::size_t foldedInAll = 0, asked = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Dish dish;
    dish.input.map.depthScale = random.uniform(0.5, 3);
    dish.input.map.depthOffset = random.uniform(0, 25);
    const Mesh& mesh = *dish.input.original;
    MappedPoints mapped;
    mapPointsThrough(dish.input.map, mesh.positions, mapped);
    const Folds folds = findFolds(dish.input.map, mesh.positions, mesh.triangles, mapped.status);
    const Folds again = findFolds(dish.input.map, mesh.positions, mesh.triangles, mapped.status, 3);
    EXPECT_EQ(folds.folded, again.folded);
    EXPECT_EQ(folds.share, again.share);
    EXPECT_EQ(static_cast<std::size_t>(std::count(folds.folded.begin(), folds.folded.end(), 1)), folds.count);
    foldedInAll += folds.count;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const Triangle& t = mesh.triangles[i];
      const auto isMapped = [&](std::uint32_t v) { return mapped.status[v] == PathStatus::mapped; };
      if (!std::all_of(t.begin(), t.end(), isMapped)) continue;
      const Point middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3.0;
      const auto bundle = bundleAround(dish.input.map, middle);
      if (!bundle) continue;
      const bool turned = bundle->spread(bundle->distance()) < 0;
      const bool isFolded = !folds.folded.empty() && folds.folded[i];
      differing += (turned != folds.reversed) != isFolded;
      ++asked;
    }
    EXPECT_LT(differing, mesh.triangles.size() / 20)
        << "only those at the focus itself may differ, or are edge-on";
  }
  EXPECT_GT(foldedInAll, 1000u);
  EXPECT_GT(asked, 10000u);
}

}  // namespace
}  // namespace anamorph
