#include "edit/live_updater.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "anamorphosis/vertex_ray.h"
#include "geometry/mesh_files.h"
#include "geometry/shapes.h"
#include "pipeline/changing_levels.h"
#include "raytrace/render.h"
#include "shapes.h"

namespace anamorph {
namespace {

using namespace testing;

const std::filesystem::path levels = ANAMORPH_LEVELS;
constexpr UpdateOptions quick{40, false};

/// Opens an installed level and makes it as small as quickLevels() are.
void openQuick(Session& session, const std::string& name, int segments = 6) {
  session.open(levels / (name + ".json"));
  Level level = session.level();
  if (auto* box = std::get_if<BoxShape>(&level.original.shape)) box->segments = segments;
  level.sculpture.tolerancePixels = 1;
  session.edit(level);
}

template <typename Condition>
bool updateUntil(LiveUpdater& updater, const Session& session, const UpdateOptions& options,
                 const Condition& condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < end) {
    updater.update(session, options);
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

template <typename Condition>
bool waitUntil(const Condition& condition) {
  for (int i = 0; i < 30000 && !condition(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return condition();
}

/// Everything at rest is what the pipeline makes of the level when nothing has gone before.
void expectEvaluated(const LevelResult& result, const Session& session, const UpdateOptions& options) {
  Evaluator evaluator;
  const LevelResult wanted = *evaluator.evaluate({session.level(), session.path(), options.previewSize}, 2);
  EXPECT_EQ(result.level, session.level());
  EXPECT_EQ(*result.shape, *wanted.shape);
  EXPECT_EQ(*result.original.mesh, *wanted.original.mesh);
  EXPECT_EQ(result.sculpture.sculpture->mesh, wanted.sculpture.sculpture->mesh);
  EXPECT_EQ(result.problem, wanted.problem);
  EXPECT_EQ(result.warnings, wanted.warnings);
  ASSERT_EQ(result.match == nullptr, wanted.match == nullptr);
  if (wanted.match) {
    EXPECT_EQ(result.match->report.width, wanted.match->report.width);
    EXPECT_EQ(result.match->report.silhouetteIou, wanted.match->report.silhouetteIou);
    EXPECT_EQ(result.match->classes, wanted.match->classes);
  }
  EXPECT_EQ(*result.previews.reflection, *wanted.previews.reflection);
  EXPECT_EQ(*result.previews.original, *wanted.previews.original);
  ASSERT_EQ(result.previews.difference == nullptr, wanted.previews.difference == nullptr);
  EXPECT_TRUE(!wanted.previews.difference || *result.previews.difference == *wanted.previews.difference);
  EXPECT_TRUE(result.refined && result.complete);
  const PixelGrid& grid = session.level().grid;
  ASSERT_TRUE(result.scene && result.screen);
  EXPECT_EQ(result.scene->input, makeReflectionScene(session.level(), result.sculpture));
  EXPECT_EQ(result.screen->width, grid.columns);
  EXPECT_EQ(result.screen->height, grid.rows);
}

/// What is shown in the frame of a change: all of it of the level as it is now.
void expectFollowing(const LevelResult& result, const Level& level) {
  EXPECT_EQ(result.level, level);
  EXPECT_FALSE(result.refined || result.complete);
  EXPECT_EQ(*result.original.mesh,
            *placeOriginal(*result.shape, level.original.unitize, level.original.placement));
  ASSERT_TRUE(result.previews.reflection && result.previews.original);
  const int width = result.previews.reflection->width, height = result.previews.reflection->height;
  EXPECT_LE(std::max(width, height), 64) << "coarse";
  EXPECT_EQ(pictureSize(level.grid, std::max(width, height)), std::pair(width, height));
  EXPECT_EQ(result.previews.original->width, width);
  EXPECT_EQ(result.previews.original->height, height);
  ASSERT_TRUE(result.scene && result.screen);
  EXPECT_EQ(result.scene->input, makeReflectionScene(level, result.sculpture));
  EXPECT_EQ(result.problem.has_value(), result.sculpture.sculpture->mesh.triangles.empty());
  EXPECT_EQ(result.match == nullptr, result.problem.has_value());
  EXPECT_EQ(result.previews.difference == nullptr, result.problem.has_value());
  EXPECT_TRUE(!result.match || result.match->report.width == width);
  const Sculpture& sculpture = *result.sculpture.sculpture;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < sculpture.original.size(); ++i) {
    const MappedPoint mapped = mapPoint(makeVertexMap(level), sculpture.original[i]);
    wrong += sculpture.mesh.positions[i] != mapped.point || sculpture.status[i] != mapped.status;
  }
  EXPECT_EQ(wrong, 0u);
}

TEST(LiveUpdater, FinishedResultsAreThoseOfThePipeline) {
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    SCOPED_TRACE(name);
    Session session;
    openQuick(session, name);
    LiveUpdater updater({}, 2);
    updater.finish(session, quick);
    expectEvaluated(updater.result(), session, quick);
    EXPECT_EQ(updater.result().trees, nullptr);
    EXPECT_FALSE(updater.update(session, quick)) << "nothing is new";
  }
}

TEST(LiveUpdater, TreesAreTheRaysOfTheGridWhenAskedFor) {
  Session session;
  openQuick(session, "2-cylinder");
  Level level = session.level();
  level.grid.columns = 5;
  level.grid.rows = 3;
  session.edit(level);
  LiveUpdater updater({}, 2);
  const UpdateOptions withTrees{40, true};
  updater.finish(session, withTrees);
  const LevelResult& result = updater.result();
  ASSERT_TRUE(result.trees);
  ASSERT_EQ(result.trees->size(), 15u);
  const ImageRequest request = makeImageRequest(level, 5, 3, 1);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const RayTree wanted = tracePath(*result.scene, level.camera, request, {x + 0.5, y + 0.5});
      const RayTree& tree = (*result.trees)[static_cast<std::size_t>(5 * y + x)];
      EXPECT_EQ(tree.color, wanted.color);
      EXPECT_EQ(tree.segments.size(), wanted.segments.size());
    }
  }
  const auto before = result.trees;
  updater.update(session, withTrees);
  EXPECT_EQ(result.trees, before) << "kept";
  EXPECT_TRUE(updater.update(session, quick));
  EXPECT_EQ(result.trees, nullptr);
}

TEST(LiveUpdater, SculptureFollowsInTheSameCallAndSettlesAfterTheDrag) {
  int problems = 0;
  for (const char* name : {"1-plane", "2-cylinder", "3-sphere"}) {
    for (unsigned seed = 0; seed < 3; ++seed) {
      SCOPED_TRACE(name + std::string(", seed ") + std::to_string(seed));
      Random random(seed);
      Session session;
      openQuick(session, name);
      LiveUpdater updater({}, 2);
      updater.finish(session, quick);
      const Level start = session.level();
      for (int i = 0; i < 8; ++i) {
        session.change(changed(start, random, i < 4 ? 0.3 : 4));
        EXPECT_TRUE(updater.update(session, quick));
        expectFollowing(updater.result(), session.level());
        problems += updater.result().problem.has_value();
        EXPECT_GT(updater.liveTimes().total(), 0);
      }
      session.finishChange();
      updater.finish(session, quick);
      expectEvaluated(updater.result(), session, quick);
    }
  }
  EXPECT_GT(problems, 0);
}

TEST(LiveUpdater, OriginalsPictureIsTakenInTheFrameOnlyWhenWanted) {
  Session session;
  openQuick(session, "2-cylinder");
  LiveUpdater updater({}, 2);
  const UpdateOptions reflectionOnly{40, false, false};
  updater.finish(session, reflectionOnly);
  expectEvaluated(updater.result(), session, reflectionOnly);
  Level level = session.level();
  for (const bool wanted : {false, true, false}) {
    level.camera.eye.x += 0.1;
    session.change(level);
    updater.update(session, {40, false, wanted});
    const LevelResult& result = updater.result();
    EXPECT_TRUE(result.match && result.previews.reflection);
    EXPECT_EQ(result.previews.original != nullptr, wanted) << "never the one of another level";
    EXPECT_EQ(result.previews.difference != nullptr, wanted);
  }
  session.finishChange();
  updater.finish(session, reflectionOnly);
  expectEvaluated(updater.result(), session, reflectionOnly);
}

TEST(LiveUpdater, TimesOfTheLastMoveStayWhenNothingMoves) {
  Session session;
  openQuick(session, "1-plane");
  LiveUpdater updater({}, 2);
  updater.finish(session, quick);
  Level level = session.level();
  level.camera.eye.x += 0.5;
  session.change(level);
  updater.update(session, quick);
  const double total = updater.liveTimes().total();
  EXPECT_GT(updater.liveTimes().rays, 0);
  updater.update(session, quick);
  EXPECT_EQ(updater.liveTimes().total(), total);
}

TEST(LiveUpdater, CancelledDragSettlesWhereItBegan) {
  Session session;
  openQuick(session, "3-sphere");
  LiveUpdater updater({}, 2);
  updater.finish(session, quick);
  Level level = session.level();
  level.camera.eye.x += 2;
  session.change(level);
  updater.update(session, quick);
  session.cancelChange();
  updater.update(session, quick);
  expectFollowing(updater.result(), session.level());
  updater.finish(session, quick);
  expectEvaluated(updater.result(), session, quick);
}

TEST(LiveUpdater, PauseInADragGetsItsSettledState) {
  Session session;
  openQuick(session, "2-cylinder");
  LiveUpdater updater({}, 2);
  updater.finish(session, quick);
  Level level = session.level();
  for (int pause = 0; pause < 2; ++pause) {
    level.camera.eye.x += 0.7;
    session.change(level);
    updater.update(session, quick);
    EXPECT_TRUE(updater.busy()) << "it will be";
    if (const auto seconds = updater.secondsUntilDue()) {  // else the update alone took longer than a rest
      EXPECT_GE(*seconds, 0);
      EXPECT_LE(*seconds, 0.25);
    }
    EXPECT_FALSE(updater.result().complete);
    while (!updater.result().complete) {
      const bool busy = updater.busy();
      updater.update(session, quick);
      ASSERT_TRUE(busy || updater.result().complete) << "a window would have fallen asleep";
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_TRUE(session.changing());
    EXPECT_EQ(updater.secondsUntilDue(), std::nullopt);
    expectEvaluated(updater.result(), session, quick);
    level.sculpture.depthScale *= 0.9;
    session.change(level);
    updater.update(session, quick);
    expectFollowing(updater.result(), level);
  }
}

TEST(LiveUpdater, ProblemComesAndGoes) {
  Session session;
  openQuick(session, "3-sphere");
  LiveUpdater updater({}, 2);
  updater.finish(session, quick);
  const Level good = session.level();
  Level touching = good;
  touching.camera.eye = pointAt(good.optic.shape(), 0.2, 0.6);
  Level flat = good;
  changeShape<SphereMirror>(flat.optic.shape(), [](auto& s) { s.radius = 0; });
  Level tiny = good;
  tiny.original.placement.scale = Vector(0);
  Level beside = good;
  beside.original.placement.position.x = 200;
  for (const Level& bad : {touching, flat, tiny, beside}) {
    // In one drag ...
    for (const Level* level : {&bad, &good, &bad, &good}) {
      session.change(*level);
      updater.update(session, quick);
      expectFollowing(updater.result(), *level);
      EXPECT_EQ(updater.result().problem.has_value(), level == &bad);
    }
    session.finishChange();
    updater.finish(session, quick);
    expectEvaluated(updater.result(), session, quick);
    // ... and with a rest in it.
    for (const Level* level : {&bad, &good}) {
      session.edit(*level);
      updater.update(session, quick);
      EXPECT_EQ(updater.result().problem.has_value(), level == &bad);
      updater.finish(session, quick);
      expectEvaluated(updater.result(), session, quick);
    }
    session.edit(bad);
    updater.finish(session, quick);
    session.change(good);
    updater.update(session, quick);
    expectFollowing(updater.result(), good);
    EXPECT_EQ(updater.result().problem, std::nullopt);
    session.finishChange();
    updater.finish(session, quick);
  }
}

TEST(LiveUpdater, WhateverHappensMeanwhileTheEndIsRight) {
  const char* names[] = {"1-plane", "2-cylinder", "3-sphere"};
  const OriginalShape shapes[] = {BoxShape{{6, 2, 2}, 6}, BoxShape{{2, 2, 2}, 1}, SphereShape{1, 16},
                                  FileShape{"../tests/data/meshes/cube.obj"}, FileShape{"nothing.obj"}};
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Session session;
    openQuick(session, names[seed % 3]);
    LiveUpdater updater({}, 2);
    for (int i = 0; i < 30; ++i) {
      Level level = session.level();
      switch (random.integer(0, 8)) {
        case 0:
          level.original.shape = shapes[random.integer(0, 4)];
          session.edit(level);
          break;
        case 1:
          openQuick(session, names[random.integer(0, 2)]);
          break;
        case 2:
          session.finishChange();
          break;
        case 3:
          session.undo();
          break;
        case 4:
          session.redo();
          break;
        case 5:
          session.edit(changed(level, random, 0.5));
          break;
        case 6:
          if (random.integer(0, 3) == 0) updater.cancel();
          break;
        default:
          session.change(changed(level, random, random.uniform(0, 2)));
      }
      if (random.integer(0, 3) > 0) updater.update(session, quick);
      std::this_thread::sleep_for(std::chrono::microseconds(int(std::pow(10, random.uniform(0, 4.5)))));
    }
    Level level = session.level();
    if (level.original.shape == shapes[4]) {
      updater.finish(session, quick);
      ASSERT_TRUE(updater.result().problem);
      EXPECT_NE(updater.result().problem->find("nothing.obj"), std::string::npos);
      level.original.shape = shapes[0];
    }
    level.text.edit([&](LevelText& text) { text.title = "the last one"; });  // whatever was cancelled
    session.edit(level);
    updater.finish(session, quick);
    expectEvaluated(updater.result(), session, quick);
  }
}

TEST(LiveUpdater, LevelOpenedWhileTheWorkerIsBusyTakesOver) {
  Session session;
  session.open(levels / "3-sphere.json");
  Level heavy = session.level();
  heavy.sculpture.tolerancePixels = 0.02;
  session.edit(heavy);
  LiveUpdater updater({}, 2);
  updater.update(session, quick);
  openQuick(session, "1-plane");
  EXPECT_TRUE(updater.update(session, quick));
  EXPECT_EQ(updater.result().level, session.level());
  EXPECT_EQ(updater.result().sculpture.sculpture, nullptr) << "nothing of the other level is shown";
  updater.finish(session, quick);
  expectEvaluated(updater.result(), session, quick);
}

TEST(LiveUpdater, MeshFileThatFailsIsAProblemAndLaterRecovers) {
  Session session;
  openQuick(session, "1-plane");
  const Level good = session.level();
  Level bad = good;
  bad.original.shape = FileShape{"nothing.obj"};
  LiveUpdater updater({}, 2);
  for (int round = 0; round < 2; ++round) {
    session.edit(bad);
    updater.finish(session, quick);
    ASSERT_TRUE(updater.result().problem);
    EXPECT_NE(updater.result().problem->find("nothing.obj"), std::string::npos) << *updater.result().problem;
    EXPECT_FALSE(updater.result().refined);
    session.undo();
    updater.finish(session, quick);
    expectEvaluated(updater.result(), session, quick);
  }
}

/// A level in a folder of its own, whose original is a file.
class LevelWithAFile : public ::testing::Test {
 protected:
  LevelWithAFile() {
    std::string name = (std::filesystem::temp_directory_path() / "anamorph-studio-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    Level level = quickLevels()[0];
    level.original.shape = FileShape{"mesh.obj"};
    saveLevel(levelPath(), level);
  }
  ~LevelWithAFile() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path levelPath() const { return folder_ / "level.json"; }
  void writeBox(int segments) const { saveMesh(folder_ / "mesh.obj", makeBox({6, 2, 2}, segments)); }

 private:
  std::filesystem::path folder_;
};

TEST_F(LevelWithAFile, FailureOfALevelIsNotTheNextOnes) {
  Session session;
  session.open(levelPath());
  std::atomic<int> wakes{0};
  LiveUpdater updater([&] { ++wakes; }, 2);
  updater.update(session, quick);
  ASSERT_TRUE(waitUntil([&] { return wakes > 0; })) << "it has failed, and nobody has looked yet";
  openQuick(session, "1-plane");
  updater.update(session, quick);
  EXPECT_EQ(updater.result().problem, std::nullopt);
  EXPECT_FALSE(updater.result().complete);
  updater.finish(session, quick);
  expectEvaluated(updater.result(), session, quick);
}

TEST_F(LevelWithAFile, OpenedAgainReadsItsMeshAgain) {
  Session session;
  session.open(levelPath());
  LiveUpdater updater({}, 2);
  updater.finish(session, quick);
  ASSERT_TRUE(updater.result().problem) << "there is no mesh yet";
  EXPECT_EQ(updater.result().sculpture.sculpture, nullptr);
  for (const int segments : {3, 5}) {
    writeBox(segments);
    session.open(levelPath());
    updater.finish(session, quick);
    EXPECT_EQ(updater.result().problem, std::nullopt);
    EXPECT_EQ(updater.result().shape->triangles.size(), std::size_t(12 * segments * segments));
    expectEvaluated(updater.result(), session, quick);
  }
}

TEST(LiveUpdater, AnotherPreviewSizeIsNotCompleteUntilItIsThere) {
  Session session;
  openQuick(session, "1-plane");
  LiveUpdater updater({}, 2);
  for (const int size : {32, 64, 0, 32}) {
    updater.finish(session, {size, false});
    EXPECT_EQ(updater.result().previews.reflection->width, size > 0 ? size : 8);
    expectEvaluated(updater.result(), session, {size, false});
  }
}

TEST(LiveUpdater, CancelStopsUntilTheLevelChanges) {
  Session session;
  session.open(levels / "3-sphere.json");
  Level level = session.level();
  level.sculpture.tolerancePixels = 0.02;
  session.edit(level);
  LiveUpdater updater({}, 2);
  updater.update(session, quick);
  updater.cancel();
  ASSERT_TRUE(updateUntil(updater, session, quick, [&] { return !updater.busy(); }));
  for (int i = 0; i < 20; ++i) {
    updater.update(session, quick);
    EXPECT_FALSE(updater.busy());
  }
  EXPECT_FALSE(updater.result().complete);
  openQuick(session, "3-sphere");
  updater.update(session, quick);
  updater.cancel();
  level = session.level();
  level.text.edit([&](LevelText& text) { text.title = "changed"; });
  session.edit(level);
  ASSERT_TRUE(updateUntil(updater, session, quick, [&] { return updater.result().complete; }));
  expectEvaluated(updater.result(), session, quick);
}

TEST(LiveUpdater, FinishAfterCancelFinishes) {
  Session session;
  openQuick(session, "1-plane");
  LiveUpdater updater({}, 2);
  updater.update(session, quick);
  updater.cancel();
  updater.finish(session, quick);
  expectEvaluated(updater.result(), session, quick);
}

TEST(LiveUpdater, WakesWhenThereIsSomethingToTake) {
  Session session;
  openQuick(session, "1-plane");
  std::atomic<int> wakes{0};
  LiveUpdater updater([&] { ++wakes; }, 2);
  updater.update(session, quick);
  int taken = 0;
  // As a window does: it looks only when woken.
  while (!updater.result().complete) {
    ASSERT_TRUE(waitUntil([&] { return wakes > taken; }));
    taken = wakes;
    updater.update(session, quick);
  }
  EXPECT_TRUE(waitUntil([&] { return wakes >= 3; })) << "step by step";
}

TEST(LiveUpdater, LargeOriginalsDoNotFollowInTheFrame) {
  Session session;
  openQuick(session, "1-plane", 183);
  Level level = session.level();
  level.sculpture.tolerancePixels = 0;
  session.edit(level);
  LiveUpdater updater({}, 2);
  const UpdateOptions small{16, false};
  updater.finish(session, small);
  const LevelResult& result = updater.result();
  ASSERT_GT(result.shape->positions.size(), 2 * LiveUpdater::liveVerticesPerThread);
  ASSERT_TRUE(waitUntil([&] { return !updater.busy(); }));
  EXPECT_TRUE(result.refined && result.match);
  const auto original = result.original.mesh;
  const auto sculpture = result.sculpture.sculpture;
  const auto match = result.match;
  for (int i = 0; i < 10; ++i) {
    level.original.placement.position.x += 0.01;
    session.change(level);
    EXPECT_TRUE(updater.update(session, small));
    EXPECT_EQ(result.level, level);
    EXPECT_FALSE(result.refined || result.complete);
    EXPECT_TRUE(updater.busy());
    if (i > 0) continue;  // later on the worker may have delivered
    EXPECT_EQ(result.original.mesh, original);
    EXPECT_EQ(result.sculpture.sculpture, sculpture);
    EXPECT_EQ(result.match, match);
    const LiveTimes& times = updater.liveTimes();
    EXPECT_EQ(times.original + times.sculpture + times.preview + times.match, 0);
  }
  // While the drag goes on, what the worker makes is shown though it is of a moment ago.
  ASSERT_TRUE(updateUntil(updater, session, small, [&] { return result.sculpture.sculpture != sculpture; }));
  session.finishChange();
  updater.finish(session, small);
  EXPECT_EQ(result.level, level);
  EXPECT_EQ(*result.original.mesh, *placeOriginal(*result.shape, false, level.original.placement));

  std::get<BoxShape>(level.original.shape).segments = 4;
  session.edit(level);
  updater.finish(session, small);
  expectEvaluated(result, session, small);
  level.camera.eye.x += 0.1;
  session.change(level);
  updater.update(session, small);
  expectFollowing(result, level);
}

}  // namespace
}  // namespace anamorph
