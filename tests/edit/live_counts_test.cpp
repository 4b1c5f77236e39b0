// What a change costs in the frame, counted: only what depends on it is computed anew.

#include <filesystem>
#include <functional>
#include <utility>
#include <variant>

#include <gtest/gtest.h>

#include "edit/live_updater.h"
#include "edit/session.h"
#include "pipeline/picture.h"

namespace anamorph {
namespace {

const std::filesystem::path levels = ANAMORPH_LEVELS;
constexpr UpdateOptions quick{40, true};

class LiveCosts : public ::testing::Test {
 protected:
  LiveCosts() {
    session_.open(levels / "2-cylinder.json");
    Level level = session_.level();
    std::get<BoxShape>(level.original.shape).segments = 6;
    level.sculpture.tolerancePixels = 1;
    session_.edit(level);
    updater_.finish(session_, quick);
  }

  using Change = std::function<void(Level&)>;

  // Ten frames of a drag, and what they have cost.
  LiveCounts drag(const Change& change) {
    const LiveCounts before = updater_.liveCounts();
    for (int i = 0; i < 10; ++i) {
      Level level = session_.level();
      change(level);
      session_.change(level);
      updater_.update(session_, quick);
    }
    const LiveCounts& after = updater_.liveCounts();
    return {after.originals - before.originals, after.sculptures - before.sculptures,
            after.matches - before.matches, after.pictures - before.pictures};
  }

  Session session_;
  LiveUpdater updater_{{}, 2};
};

TEST_F(LiveCosts, AnEyeThatMovesCostsSculptureMatchAndPictures) {
  const LiveCounts cost = drag([](Level& level) { level.camera.eye.x += 0.01; });
  EXPECT_EQ(cost, (LiveCounts{0, 10, 10, 20}));
}

TEST_F(LiveCosts, AnOriginalThatMovesIsPlacedToo) {
  const LiveCounts cost = drag([](Level& level) { level.original.placement.position.z += 0.01; });
  EXPECT_EQ(cost, (LiveCounts{10, 10, 10, 20}));
}

TEST_F(LiveCosts, ALightsColourCostsNoDeformationAndNoMatch) {
  const LevelResult before = updater_.result();
  const LiveCounts cost = drag([](Level& level) { level.lights[0].color.x *= 0.95; });
  EXPECT_EQ(cost.originals + cost.sculptures + cost.matches, 0u);
  EXPECT_EQ(cost.pictures, 20u);
  EXPECT_EQ(updater_.result().sculpture, before.sculpture) << "nor is anything uploaded";
  EXPECT_EQ(updater_.result().match, before.match);
  EXPECT_TRUE(updater_.result().refined);
}

TEST_F(LiveCosts, ALightsColourInTheMidstOfADragCostsNoDeformation) {
  drag([](Level& level) { level.camera.eye.x += 0.01; });
  const PreparedSculpture followed = updater_.result().sculpture;
  const LiveCounts cost = drag([](Level& level) { level.lights[1].color.y *= 0.95; });
  EXPECT_EQ(cost.originals + cost.sculptures + cost.matches, 0u);
  EXPECT_EQ(updater_.result().sculpture, followed);
}

TEST_F(LiveCosts, TheSculpturesColourCostsItsPictureOnly) {
  const LiveCounts cost = drag([](Level& level) { level.sculpture.material.color.z *= 0.95; });
  EXPECT_EQ(cost, (LiveCounts{0, 0, 0, 10}));
}

TEST_F(LiveCosts, WhereTheGridIsDrawnCostsNothing) {
  const LevelResult before = updater_.result();
  const LiveCounts cost = drag([](Level& level) { level.grid.distance += 0.01; });
  EXPECT_EQ(cost, LiveCounts{});
  session_.finishChange();
  updater_.finish(session_, quick);
  const LevelResult& after = updater_.result();
  EXPECT_EQ(after.sculpture, before.sculpture) << "not refined anew";
  EXPECT_EQ(after.match, before.match) << "not matched anew";
  EXPECT_EQ(after.previews, before.previews) << "not rendered anew";
  EXPECT_EQ(after.screen, before.screen);
  EXPECT_EQ(after.level.grid.distance, session_.level().grid.distance);
}

// Its columns and rows are the proportions of every picture.
TEST_F(LiveCosts, AnotherGridIsAnotherPicture) {
  const LiveCounts cost = drag([](Level& level) { level.grid.columns += 1; });
  EXPECT_EQ(cost, (LiveCounts{0, 0, 10, 20}));
  const LevelResult& result = updater_.result();
  const auto size = pictureSize(session_.level().grid, LiveUpdater::coarseSize);
  EXPECT_EQ(std::pair(result.previews.reflection->width, result.previews.reflection->height), size);
  EXPECT_EQ(std::pair(result.match->report.width, result.match->report.height), size);
}

// Until another original is there, the old one is shown: nothing about it is the level's any more.
TEST_F(LiveCosts, AnotherShapeIsNotRefinedUntilItIsThere) {
  for (const OriginalShape& shape : {OriginalShape(SphereShape{}), OriginalShape(FileShape{"nothing.obj"})}) {
    Level level = session_.level();
    level.original.shape = shape;
    session_.edit(level);
    updater_.update(session_, quick);
    EXPECT_FALSE(updater_.result().refined);
    updater_.finish(session_, quick);
    EXPECT_EQ(updater_.result().refined, !updater_.result().problem);
    level.lights[0].color.x *= 0.5;  // of which the shape knows nothing
    session_.edit(level);
    updater_.update(session_, quick);
    if (std::holds_alternative<FileShape>(shape)) {
      EXPECT_FALSE(updater_.result().refined);
    }
  }
}

// A worker that is stopped early has made a sculpture and nothing else: what stands in is not taken for its own.
TEST_F(LiveCosts, WhatAStoppedWorkerLeftIsMadeInTheFrame) {
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    Level level = session_.level();
    level.camera.eye.x += 0.1;
    session_.edit(level);
    for (int k = 0; k <= i; ++k) updater_.update(session_, quick);
    level.lights[0].color.x *= 0.99;
    session_.change(level);  // stops the worker
    updater_.update(session_, quick);
    const LevelResult& result = updater_.result();
    ASSERT_TRUE(result.match);
    const MatchReport& report = result.match->report;
    const Match wanted = computeMatch(
        makeMatchInput(session_.level(), result.original, result.sculpture, report.width, report.height));
    EXPECT_EQ(report.silhouetteIou, wanted.report.silhouetteIou);
    EXPECT_EQ(report.p99Px, wanted.report.p99Px);
    session_.finishChange();
    updater_.finish(session_, quick);
  }
}

TEST_F(LiveCosts, WordsCostNothingAtAll) {
  const LevelResult before = updater_.result();
  const LiveCounts cost =
      drag([](Level& level) { level.text.edit([](LevelText& text) { text.title += "!"; }); });
  EXPECT_EQ(cost, LiveCounts{});
  EXPECT_TRUE(updater_.result().complete);
  EXPECT_FALSE(updater_.busy());
  EXPECT_EQ(updater_.result().previews, before.previews);
  EXPECT_EQ(updater_.result().level.text->title, session_.level().text->title);
}

// Levels are kept many times in the history: each has its own scene, and all share one text.
TEST_F(LiveCosts, TheHistorySharesTheText) {
  const LevelText* const text = &*session_.level().text;
  Level level = session_.level();
  level.camera.eye.x += 1;
  session_.edit(level);
  EXPECT_EQ(&*session_.level().text, text);
  session_.undo();
  EXPECT_EQ(&*session_.level().text, text);
}

}  // namespace
}  // namespace anamorph
