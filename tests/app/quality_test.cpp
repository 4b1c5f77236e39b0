#include "app/quality.h"

#include <limits>

#include <gtest/gtest.h>

namespace anamorph {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

QualityGovernor after(bool software, double millisecondsPerSample) {
  QualityGovernor governor(software);
  for (int i = 0; i < 50; ++i) governor.took({1, 1, 1}, millisecondsPerSample);
  return governor;
}

TEST(Quality, GraphicsCardsDrawAtFullSize) {
  for (const double milliseconds : {0.0, 0.1, 1.0, 7.0, 40.0}) {
    for (const bool moving : {true, false}) {
      const ViewQuality quality = after(false, milliseconds).next(moving, 0);
      EXPECT_EQ(quality.scale, 1);
      EXPECT_GE(quality.samplesNow, 1);
      EXPECT_LE(quality.samplesNow, 4);
      EXPECT_GE(quality.samples, quality.samplesNow);
      EXPECT_EQ(quality.milliseconds, infinite) << "nobody waits for them";
    }
  }
  EXPECT_EQ(after(false, 0.5).next(true, 0).samplesNow, 4);
  EXPECT_EQ(after(false, 20).next(true, 0).samplesNow, 1);
}

TEST(Quality, SlowDrawingHasItsTimeInEveryFrame) {
  for (const bool moving : {true, false}) {
    for (const QualityGovernor& governor : {after(true, 0.1), after(true, 1e4), after(false, 300)}) {
      QualityGovernor slow = governor;
      EXPECT_LE(slow.next(moving, 1).milliseconds, 50);
    }
  }
  EXPECT_LT(after(false, 300).next(true, 0).scale, 1) << "a graphics card may be slow, too";
  EXPECT_EQ(QualityGovernor::best().milliseconds, infinite);
}

TEST(Quality, WhatIsNotKnownIsDrawnSmall) {
  EXPECT_LE(QualityGovernor(true).next(true, 0).scale, 0.25);
  QualityGovernor governor = after(true, 1);
  EXPECT_EQ(governor.next(true, 0).scale, 1);
  governor.forget();
  EXPECT_LE(governor.next(true, 0).scale, 0.25);
}

TEST(Quality, StillPicturesBecomeFine) {
  for (const bool software : {true, false}) {
    for (const double milliseconds : {0.1, 10.0, 1000.0}) {
      const ViewQuality quality = after(software, milliseconds).next(false, 1);
      EXPECT_EQ(quality.scale, 1);
      EXPECT_GE(quality.samples, 8);
    }
  }
}

TEST(Quality, SlowProcessorsDrawSmallerWhileSomethingMoves) {
  double last = 1;
  for (const double milliseconds : {1.0, 10.0, 40.0, 80.0, 160.0, 300.0, 600.0, 1e5}) {
    const ViewQuality quality = after(true, milliseconds).next(true, 0);
    EXPECT_LE(quality.scale, last);
    EXPECT_GE(quality.scale, 0.125);
    EXPECT_EQ(quality.samples, 1);
    if (quality.scale > 0.125) {
      EXPECT_LE(quality.scale * quality.scale * milliseconds, 40 * 1.001) << "the budget";
    }
    last = quality.scale;
  }
  EXPECT_EQ(after(true, 1).next(true, 0).scale, 1);
  EXPECT_EQ(after(true, 1e5).next(true, 0).scale, 0.125);
}

TEST(Quality, TheScaleThatWasDrawnDoesNotMatter) {
  QualityGovernor full(true), half(true);
  full.took({1, 1, 1}, 100);
  half.took({0.5, 1, 1}, 25);
  EXPECT_EQ(full.next(true, 0), half.next(true, 0));
  QualityGovernor many(true);
  many.took({1, 4, 16}, 400);
  EXPECT_EQ(full.next(true, 0), many.next(true, 0));
}

TEST(Quality, SettlesOnOneScale) {
  // A machine that always needs 90 ms for a sample at full size.
  QualityGovernor governor(true);
  ViewQuality last{};
  int changes = 0;
  for (int i = 0; i < 100; ++i) {
    const ViewQuality quality = governor.next(true, 0);
    changes += i > 5 && !(quality == last);
    last = quality;
    governor.took(quality, 90 * quality.scale * quality.scale);
  }
  EXPECT_EQ(changes, 0);
}

TEST(Quality, AShortPauseIsNotStill) {
  QualityGovernor governor = after(true, 200);
  EXPECT_LT(governor.next(false, 0.01).scale, 1);
  EXPECT_EQ(governor.next(false, 0.2).scale, 1);
}

}  // namespace
}  // namespace anamorph
