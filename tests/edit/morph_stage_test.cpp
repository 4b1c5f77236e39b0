#include "edit/morph_stage.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "edit/morph.h"
#include "geometry/shapes.h"
#include "pipeline/evaluator.h"

namespace anamorph {
namespace {

/// A box behind the default level's mirror, with more vertices than follow at once.
LevelResult largeResult() {
  Level level;
  level.sculpture.tolerancePixels = 0;
  Mesh box = makeBox({1, 1, 1}, 96);
  box.positions = mapPoints(box.positions, PlacementMap(level.original.placement));
  return *finishLevel(level, std::make_shared<const Mesh>(std::move(box)), 0);
}

TEST(MorphStage, LargeSculpturesAreMadeByAWorker) {
  const LevelResult result = largeResult();
  const Sculpture& whole = *result.sculpture.sculpture;
  ASSERT_GT(whole.mesh.positions.size(), MorphStage::vertexLimit);
  std::atomic<int> wakes{0};
  MorphStage stage([&] { ++wakes; });
  const auto at = [&](double fraction) { return stage.at(fraction, result.level, result.sculpture, 2); };
  const auto wait = [&](double fraction) {
    PreparedSculpture shown = at(fraction);
    for (int i = 0; i < 20'000 && stage.busy(); ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      shown = at(fraction);
    }
    return shown;
  };
  EXPECT_EQ(at(0.5), result.sculpture) << "nothing else is there yet";
  EXPECT_TRUE(stage.busy());
  const PreparedSculpture half = wait(0.5);
  EXPECT_EQ(half.sculpture->mesh.positions, morphPoints(whole, makeVertexMap(result.level), 0.5));
  EXPECT_GE(wakes, 1);
  EXPECT_EQ(at(0.25), half) << "the last state, until the next one is made";
  EXPECT_TRUE(stage.busy());
  const PointArray kept = half.sculpture->mesh.positions;
  EXPECT_EQ(wait(0.25).sculpture->mesh.positions, morphPoints(whole, makeVertexMap(result.level), 0.25));
  EXPECT_EQ(half.sculpture->mesh.positions, kept) << "what is held stays";
  EXPECT_EQ(at(1), result.sculpture);
  EXPECT_FALSE(stage.busy());
  const LevelResult other = largeResult();
  EXPECT_EQ(stage.at(0.25, other.level, other.sculpture, 2), other.sculpture)
      << "not a state of another sculpture";
}

}  // namespace
}  // namespace anamorph
