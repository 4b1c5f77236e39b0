#include "edit/level_helpers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "anamorphosis/map_points.h"
#include "edit/edit_levels.h"
#include "edit/level_repairs.h"
#include "edit/level_trial.h"
#include "geometry/shapes.h"
#include "level/freeze.h"
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

Trial trial(const Level& level, const std::shared_ptr<const Mesh>& placed, int size = fullTrial) {
  const Progress silent;
  return Trials(1, silent, 1).at(level, placed, size);
}

std::string told(const Trial& t) {
  return fmt::format("sound {}, mapped {}, hidden {}, missed {}, IoU {}, {}", t.sound, t.mapped,
                     t.hiddenShare, t.missedShare, t.silhouetteIou, matchGradeName(t.grade));
}

// The rule of all help: what it makes is no worse than what was there.
TEST(FittedToMirror, IsLargeAndClearOrLeavesAlone) {
  const Mesh shape = makeBox({2, 1, 1}, 3);
  int fitted = 0, kept = 0, cannot = 0;
  for (const ShapeKind kind : allShapeKinds) {
    for (unsigned seed = 0; seed < 20; ++seed) {
      SCOPED_TRACE("mirror " + std::to_string(int(kind)) + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = makeRandomLevel(kind, random);
      level.sculpture.tolerancePixels = 1;
      level.ground.visible = seed % 2 == 0;
      const auto mesh = placedMesh(level, shape);
      const Point centre = boundingBox(mesh->positions).centre();
      const Trial before = trial(level, mesh);
      const auto made = originalFittedToMirror(level, mesh);
      if (!made) {
        EXPECT_FALSE(before.clear());
        ++cannot;
        continue;
      }
      const auto now = placedMesh(*made, shape);
      EXPECT_EQ(unmapped(*made, now->positions), 0u);
      const Trial after = trial(*made, now);
      EXPECT_TRUE(after.clear()) << told(after);
      EXPECT_TRUE(isNoWorse(after, before)) << told(before) << " -> " << told(after);
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
      const Trial tooLarge = trial(moreLevel, larger);
      EXPECT_TRUE(unmapped(level, more) > 0 || !tooLarge.clear() || !isNoWorse(tooLarge, before))
          << told(tooLarge);
    }
  }
  std::printf("%d fitted, %d kept, %d without a size\n", fitted, kept, cannot);
  EXPECT_GT(fitted, 40);
  EXPECT_LT(cannot, 45);
}

TEST(FittedToMirror, DoesNotSpoilWhatIsRight) {
  // An original that is tall to a low eye: as large as it is mapped it would hide more than half of itself.
  Level level = loadLevel(std::filesystem::path(ANAMORPH_LEVELS) / "1-plane.json").level;
  level.camera.eye = {0, -50, 40};
  level.original.shape = BoxShape{{1, 1, 1}, 4};
  level.sculpture.tolerancePixels = 1;
  const auto mesh = placedMesh(level, makeBox({1, 1, 1}, 4));
  const Trial before = trial(level, mesh);
  ASSERT_TRUE(before.clear()) << told(before);
  const auto made = originalFittedToMirror(level, mesh);
  ASSERT_TRUE(made);
  EXPECT_TRUE(trial(*made, placedMesh(*made, makeBox({1, 1, 1}, 4))).clear());
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

// As the search turns it.
Level liftedTo(const Level& level, const Point& pivot, double degrees) {
  const Vector arm = level.camera.eye - pivot;
  const double flat = std::hypot(arm.x, arm.y), angle = radians(degrees);
  Level result = level;
  result.camera.eye = pivot + glm::length(arm) * Vector(std::cos(angle) * arm.x / flat,
                                                        std::cos(angle) * arm.y / flat, std::sin(angle));
  return result;
}

double heightOf(const Level& level, const Point& pivot) {
  const Vector arm = level.camera.eye - pivot;
  return std::atan2(arm.z, std::hypot(arm.x, arm.y)) * 180 / pi;
}

// How many degrees wide the widest band of clear heights is, looked at in steps of one degree.
int clearDegrees(const Level& level, const std::shared_ptr<const Mesh>& mesh, const Point& pivot) {
  int widest = 0, now = -1;
  for (double degrees = heightOf(level, pivot) + 0.37; degrees <= 85; ++degrees) {
    now = trial(liftedTo(level, pivot, degrees), mesh).clear() ? now + 1 : -1;
    widest = std::max(widest, now);
  }
  return widest;
}

// The installed levels with the eye, the original and k somewhere else.
Level disturbed(const Level& installed, Random& random) {
  Level level = installed;
  level.camera.eye += Vector(random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-6, 1));
  level.original.placement.rotationDegrees.z += random.uniform(-90, 90);
  level.original.placement.scale *= random.uniform(0.4, 1.2);
  level.original.placement.position += random.point(0.5);
  level.sculpture.depthScale = random.uniform(0.3, 1.2);
  if (random.uniform(0, 1) < 0.3) level.grid = {16, 9, 1};
  level.ground.visible = random.uniform(0, 1) < 0.5;
  return level;
}

TEST(EyeLifted, FindsAClearHeightOrLeavesAlone) {
  int lifted = 0, kept = 0, cannot = 0;
  for (const std::string name : {"1-plane", "2-cylinder", "3-sphere"}) {
    const Level installed = smallLevel(name);
    for (unsigned seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Random random(seed);
      const Level level = disturbed(installed, random);
      const auto mesh = originalOf(level);
      const Point pivot = boundingBox(mesh->positions).centre();
      const Trial before = trial(level, mesh);
      const auto made = eyeLifted(level, mesh, 2);
      if (!made) {
        ++cannot;
        if (!findEyeProblem(level.optic, level.camera.eye)) {
          EXPECT_LE(clearDegrees(level, mesh, pivot), 2) << "there is one";
        }
        continue;
      }
      if (*made == level) {
        EXPECT_TRUE(before.sound && before.hiddenShare == 0) << told(before);
        ++kept;
        continue;
      }
      ++lifted;
      const Trial after = trial(*made, mesh);
      EXPECT_TRUE(after.sound && after.hiddenShare == 0 && isNoWorse(after, before))
          << told(before) << " -> " << told(after);
      EXPECT_LE(after.missedShare, before.missedShare);
      if (!after.clear()) {
        EXPECT_LE(clearDegrees(level, mesh, pivot), 2) << "there is a better one";
      }
      EXPECT_GT(made->camera.eye.z, level.camera.eye.z);
      EXPECT_NEAR(glm::length(made->camera.eye - pivot), glm::length(level.camera.eye - pivot), 1e-9);
      Level same = *made;
      same.camera.eye = level.camera.eye;
      EXPECT_EQ(same, level) << "only the eye has moved";
    }
  }
  std::printf("%d lifted, %d kept, %d without a height\n", lifted, kept, cannot);
  EXPECT_GT(lifted, 2);
  EXPECT_GT(kept, 5);
}

// From far away a low eye sees the sculpture before its own reflection, and a higher one looks over it.
TEST(EyeLifted, OverATurnedOriginalFromFarAway) {
  Level level = smallLevel("1-plane");
  level.camera.eye = {0, -50, 8};
  level.original.placement.rotationDegrees.z = 90;
  level.original.placement.scale = Vector(0.6);
  level.sculpture.depthScale = 0.7;
  const auto mesh = originalOf(level);
  const Trial before = trial(level, mesh);
  ASSERT_GT(before.hiddenShare, 0.1) << told(before);
  ASSERT_GT(clearDegrees(level, mesh, boundingBox(mesh->positions).centre()), 2);
  const auto made = eyeLifted(level, mesh, 2);
  ASSERT_TRUE(made);
  EXPECT_TRUE(trial(*made, mesh).clear());
}

TEST(PutBehind, FindsAClearPlaceOrOneThatIsBetterOrLeavesAlone) {
  int clear = 0, better = 0, kept = 0, cannot = 0;
  for (const std::string name : {"1-plane", "2-cylinder", "3-sphere"}) {
    const Level installed = smallLevel(name);
    for (unsigned seed = 0; seed < 10; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Random random(seed);
      Level level = disturbed(installed, random);
      level.original.placement.position =
          glm::mix(level.camera.eye, level.original.placement.position, random.uniform(0.3, 1.2));
      const auto mesh = originalOf(level);
      const Trial before = trial(level, mesh);
      const auto made = originalPutBehind(level, mesh, 2);
      if (!made) {
        ++cannot;
        const auto nearest = originalMovedBehind(level, boundingBox(mesh->positions));
        EXPECT_FALSE(trial(nearest, originalOf(nearest)).clear() && !before.sound)
            << "it could have been put there";
        continue;
      }
      if (*made == level) {
        EXPECT_TRUE(before.clear()) << told(before);
        ++kept;
        continue;
      }
      const Trial after = trial(*made, originalOf(*made));
      EXPECT_TRUE(isNoWorse(after, before)) << told(before) << " -> " << told(after);
      EXPECT_TRUE(after.clear() || after.shownShare > before.shownShare)
          << told(before) << " -> " << told(after);
      ++(after.clear() ? clear : better);
      const Box box = boundingBox(originalOf(*made)->positions);
      EXPECT_EQ(originalMovedBehind(*made, box), *made) << "it is behind";
      Level same = *made;
      same.original.placement.position = level.original.placement.position;
      EXPECT_EQ(same, level) << "only its place is another";
    }
  }
  std::printf("%d clear, %d better, %d kept, %d without a place\n", clear, better, kept, cannot);
  EXPECT_GT(clear, 5);
  EXPECT_LT(cannot, 15);
}

TEST(Searches, OfAFrozenSculptureAreNone) {
  const Level level = frozen(smallLevel("1-plane"));
  const auto mesh = originalOf(level);
  EXPECT_FALSE(originalFittedToMirror(level, mesh));
  EXPECT_FALSE(eyeLifted(level, mesh));
  EXPECT_FALSE(originalPutBehind(level, mesh));
}

// However the search goes, it ends after so many levels.
TEST(Searches, AreBounded) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Level level = disturbed(smallLevel("2-cylinder"), random);
    std::get<BoxShape>(level.original.shape).segments = 2;
    level.camera.eye.z = -3;
    const auto mesh = originalOf(level);
    int tried = 0;
    Progress progress;
    progress.report = [&](double) { ++tried; };
    eyeLifted(level, mesh, 1, progress);
    EXPECT_LE(tried, 220);
    tried = 0;
    originalPutBehind(level, mesh, 1, progress);
    EXPECT_LE(tried, 40);
    tried = 0;
    originalFittedToMirror(level, mesh, 1, progress);
    EXPECT_LE(tried, 200);
  }
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
    EXPECT_NO_THROW(originalPutBehind(level, mesh));
  }
}

}  // namespace
}  // namespace anamorph
