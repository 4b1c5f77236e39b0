#include "edit/level_helpers.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "anamorphosis/map_points.h"
#include "edit/edit_levels.h"
#include "edit/level_repairs.h"
#include "geometry/shapes.h"
#include "level/level_json.h"
#include "pipeline/original.h"
#include "pipeline/stages.h"

namespace anamorph {
namespace {

using namespace testing;

std::size_t unmapped(const Level& level, const PointArray& points) {
  MappedPoints mapped;
  mapPointsThrough(makeVertexMap(level), points, mapped);
  return points.size() - countStatus(mapped.status)[0];
}

PointArray scaledAbout(const PointArray& points, const Point& centre, double factor) {
  return mapPoints(points, [&](const Point& p) { return centre + factor * (p - centre); });
}

std::shared_ptr<const Mesh> placedMesh(const Level& level, const Mesh& shape) {
  return placeOriginal(shape, level.original.unitize, level.original.placement);
}

// The rule of all help: what it makes is no worse than what was there.
TEST(FittedToMirror, IsLargeAndClearOrLeavesAlone) {
  const Mesh shape = makeBox({2, 1, 1}, 3);
  int fitted = 0, kept = 0, cannot = 0;
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 30; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = makeRandomLevel(kind, random);
      level.sculpture.tolerancePixels = 1;
      level.ground.visible = seed % 2 == 0;
      const auto mesh = placedMesh(level, shape);
      const Point centre = boundingBox(mesh->positions).centre();
      const CoarseView before = coarseView(level, mesh, 256);
      const auto made = originalFittedToMirror(level, mesh);
      if (!made) {
        EXPECT_FALSE(before.clear());
        ++cannot;
        continue;
      }
      const auto now = placedMesh(*made, shape);
      EXPECT_EQ(unmapped(*made, now->positions), 0u);
      EXPECT_TRUE(coarseView(*made, now, 256).clear());
      if (*made == level) {
        EXPECT_TRUE(before.clear());
        ++kept;
        continue;
      }
      ++fitted;
      EXPECT_LT(glm::length(boundingBox(now->positions).centre() - centre), 1e-6 * (1 + glm::length(centre)));
      Level same = *made;
      same.original.placement = level.original.placement;
      EXPECT_EQ(same, level) << "only the placement is another";
      const Vector ratio = made->original.placement.scale / level.original.placement.scale;
      EXPECT_NEAR(ratio.x, ratio.y, 1e-9 * ratio.x);
      EXPECT_NEAR(ratio.x, ratio.z, 1e-9 * ratio.x);
      if (before.clear()) {
        EXPECT_GT(ratio.x, 1);
      }
      // A quarter more is too much, by one reason or the other.
      const PointArray more = scaledAbout(now->positions, centre, 1.25);
      auto larger = std::make_shared<Mesh>(*now);
      larger->positions = more;
      Level moreLevel = scaled(*made, {Part::original}, centre, Vector(1.25));
      EXPECT_TRUE(unmapped(level, more) > 0 || !coarseView(moreLevel, larger, 256).clear());
    }
  }
  std::printf("%d fitted, %d kept, %d without a size\n", fitted, kept, cannot);
  EXPECT_GT(fitted, 40);
  EXPECT_LT(cannot, 70);
}

TEST(FittedToMirror, DoesNotSpoilWhatIsRight) {
  // An original that is tall to a low eye: as large as it is mapped it would hide more than half of itself.
  Level level = loadLevel(std::filesystem::path(ANAMORPH_LEVELS) / "1-plane.json").level;
  level.camera.eye = {0, -50, 40};
  level.original.shape = BoxShape{{1, 1, 1}, 4};
  level.sculpture.tolerancePixels = 1;
  const auto mesh = placedMesh(level, makeBox({1, 1, 1}, 4));
  const CoarseView before = coarseView(level, mesh, 256);
  ASSERT_TRUE(before.clear()) << before.sound << ", hidden " << before.hiddenShare << ", missed "
                              << before.missedShare;
  const auto made = originalFittedToMirror(level, mesh);
  ASSERT_TRUE(made);
  EXPECT_TRUE(coarseView(*made, placedMesh(*made, makeBox({1, 1, 1}, 4)), 512).clear());
}

TEST(FittedToMirror, NothingWithoutAWay) {
  for (const Level& level : makeAbsurdLevels()) {
    EXPECT_NO_THROW(originalFittedToMirror(level, placedMesh(level, makeBox({1, 1, 1}, 1))));
  }
  Level level;
  EXPECT_FALSE(originalFittedToMirror(level, nullptr));
  EXPECT_FALSE(originalFittedToMirror(level, std::make_shared<const Mesh>()));
  level.original.placement.position = {0, -8, 3};
  EXPECT_FALSE(originalFittedToMirror(level, placedMesh(level, makeBox({1, 1, 1}, 1))))
      << "before the mirror";
}

std::shared_ptr<const Mesh> originalOf(const Level& level) {
  return placeOriginal(*loadOriginal(level.original.shape, {}).mesh, level.original.unitize,
                       level.original.placement);
}

Level smallLevel(const std::string& name) {
  Level level = loadLevel(std::filesystem::path(ANAMORPH_LEVELS) / (name + ".json")).level;
  std::get<BoxShape>(level.original.shape).segments = 6;
  level.sculpture.tolerancePixels = 1;
  return level;
}

TEST(EyeLifted, UntilNothingIsHidden) {
  int lifts = 0;
  for (const std::string name : {"1-plane", "2-cylinder", "3-sphere"}) {
    const Level installed = smallLevel(name);
    const auto mesh = originalOf(installed);
    const Point pivot = boundingBox(mesh->positions).centre();
    for (const double lower : {0.0, 2.0, 4.0, 5.5}) {
      SCOPED_TRACE(name + ", lower by " + std::to_string(lower));
      Level level = installed;
      level.camera.eye.z -= lower;
      const CoarseView before = coarseView(level, mesh, 256);
      const auto made = eyeLifted(level, mesh, 2);
      if (!made) continue;
      if (before.sound && before.hiddenShare == 0) {
        EXPECT_EQ(*made, level) << "nothing was hidden";
        continue;
      }
      ++lifts;
      const CoarseView after = coarseView(*made, mesh, 256);
      EXPECT_TRUE(after.sound);
      EXPECT_EQ(after.hiddenShare, 0);
      EXPECT_LE(after.missedShare, std::max(before.missedShare, 0.005));
      EXPECT_GT(made->camera.eye.z, level.camera.eye.z);
      EXPECT_NEAR(glm::length(made->camera.eye - pivot), glm::length(level.camera.eye - pivot), 1e-9);
      Level same = *made;
      same.camera.eye = level.camera.eye;
      EXPECT_EQ(same, level) << "only the eye has moved";
      // Half a degree less shows something hidden, or what it hides is smaller than a coarse pixel.
      const Vector arm = made->camera.eye - pivot;
      const double height = std::atan2(arm.z, std::hypot(arm.x, arm.y)) - radians(1.5);
      const double flat = std::hypot(arm.x, arm.y);
      Level less = *made;
      less.camera.eye = pivot + glm::length(arm) * Vector(std::cos(height) * arm.x / flat,
                                                          std::cos(height) * arm.y / flat, std::sin(height));
      if (less.camera.eye.z > level.camera.eye.z) {
        const CoarseView view = coarseView(less, mesh, 256);
        EXPECT_TRUE(!view.sound || view.hiddenShare > 0 || view.missedShare > before.missedShare);
      }
    }
  }
  EXPECT_GT(lifts, 0);
}

TEST(EyeLifted, IsCancelledSoonAndReportsHowFarItIs) {
  Level level = smallLevel("1-plane");
  level.camera.eye.z = 0.5;
  const auto mesh = originalOf(level);
  Progress progress;
  int reports = 0;
  double last = -1;
  progress.report = [&](double fraction) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    last = fraction;
    if (++reports == 3) progress.token.cancel();
  };
  EXPECT_FALSE(eyeLifted(level, mesh, 1, progress));
  EXPECT_LE(reports, 4);
}

TEST(EyeLifted, AbsurdLevelsAreNoHarm) {
  for (const Level& level : makeAbsurdLevels()) {
    const auto mesh = placeOriginal(makeBox({1, 1, 1}, 1), false, level.original.placement);
    EXPECT_NO_THROW(eyeLifted(level, mesh));
  }
}

}  // namespace
}  // namespace anamorph
