// Drawing in pieces without anything drawn: what is asked for, in which order, how much at once.

#include "viewport/piecework.h"

#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace anamorph {
namespace {

constexpr double plenty = 1e9;  // milliseconds, but not without hurry

struct Log {
  std::vector<int> pieces;  // 100 times the job, and the piece
  int asked = 0, finished = 0;

  Piecework work{[this] { ++finished; }};

  void add(int job, int count, double millisecondsEach = 0) {
    work.add(count, [=, this](int from, int to) {
      ++asked;
      for (int i = from; i < to; ++i) {
        pieces.push_back(100 * job + i);
        std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(millisecondsEach));
      }
    });
  }
};

TEST(Piecework, WithoutTimeItIsOnePieceACall) {
  Log log;
  log.add(1, 3);
  log.add(2, 0);
  log.add(3, 2);
  for (int i = 1; i <= 5; ++i) {
    ASSERT_FALSE(log.work.empty());
    log.work.drawSome(0);
    EXPECT_EQ(log.pieces.size(), static_cast<std::size_t>(i));
    EXPECT_EQ(log.finished, i) << "each is waited for";
  }
  EXPECT_TRUE(log.work.empty());
  EXPECT_EQ(log.pieces, (std::vector{100, 101, 102, 300, 301}));
}

TEST(Piecework, WithoutHurryAJobIsAskedForOnceAndNobodyWaits) {
  Log log;
  log.add(1, 90);
  log.add(2, 90);
  for (int i = 0; i < 2; ++i) log.work.drawSome(Piecework::noHurry);
  EXPECT_TRUE(log.work.empty());
  EXPECT_EQ(log.pieces.size(), 180u);
  EXPECT_EQ(log.asked, 2);
  EXPECT_EQ(log.finished, 0);
}

TEST(Piecework, QuickPiecesAreTakenTogether) {
  Log log;
  log.add(1, 1000);
  while (!log.work.empty()) log.work.drawSome(plenty);
  EXPECT_EQ(log.pieces.size(), 1000u);
  EXPECT_LE(log.asked, 10) << "1, 2, 4, 8, ...";
}

TEST(Piecework, SlowPiecesAreNot) {
  Log log;
  log.add(1, 8, 5);
  while (!log.work.empty()) log.work.drawSome(6);
  EXPECT_EQ(log.asked, 8);
}

TEST(Piecework, TheNextJobIsMeasuredAnew) {
  Log log;
  log.add(1, 64);
  log.add(2, 2, 5);
  while (log.pieces.size() < 64) log.work.drawSome(plenty);
  const int asked = log.asked;
  log.work.drawSome(plenty);
  EXPECT_EQ(log.pieces.size(), 65u) << "one, though those before were quick";
  EXPECT_EQ(log.asked, asked + 1);
}

TEST(Piecework, TellsHowFarItIs) {
  Log log;
  EXPECT_EQ(log.work.fraction(), 0);
  log.add(1, 3);
  log.add(2, 1);
  for (int i = 1; i <= 4; ++i) {
    log.work.drawSome(0);
    EXPECT_EQ(log.work.fraction(), i / 4.0);
  }
  log.add(3, 2);
  EXPECT_EQ(log.work.fraction(), 0) << "of what is new";
}

TEST(Piecework, WhatIsForgottenIsNotDrawn) {
  Log log;
  log.add(1, 3);
  log.work.drawSome(0);
  log.work.clear();
  EXPECT_TRUE(log.work.empty());
  log.add(2, 1);
  log.work.drawSome(Piecework::noHurry);
  EXPECT_EQ(log.pieces, (std::vector{100, 200}));
}

}  // namespace
}  // namespace anamorph
