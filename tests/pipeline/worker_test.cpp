#include "pipeline/worker.h"

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace anamorph {
namespace {

using namespace std::chrono_literals;

template <typename Condition>
bool waitUntil(const Condition& condition) {
  for (int i = 0; i < 5000 && !condition(); ++i) std::this_thread::sleep_for(1ms);
  return condition();
}

// Runs until it is cancelled.
void runForever(const Progress& progress) {
  while (!progress.cancelled()) std::this_thread::sleep_for(100us);
}

TEST(Worker, DeliversAndWakes) {
  Mailbox<int> box;
  std::atomic<int> wakes{0};
  Worker worker([&] { ++wakes; });
  worker.request([&](const Progress&) { box.put(42); });
  ASSERT_TRUE(waitUntil([&] { return wakes > 0; }));
  EXPECT_EQ(box.take(), 42);
  EXPECT_EQ(box.take(), std::nullopt) << "taken once";
  EXPECT_FALSE(worker.busy());
}

TEST(Worker, IsWaitedForAsLongAsOneLikes) {
  std::atomic<bool> release{false};
  Worker worker;
  EXPECT_TRUE(worker.waitForEnd(0)) << "nothing runs";
  worker.request([&](const Progress&) {
    while (!release) std::this_thread::sleep_for(100us);
  });
  EXPECT_FALSE(worker.waitForEnd(0.05));
  release = true;
  EXPECT_TRUE(worker.waitForEnd(5));
  EXPECT_FALSE(worker.busy());
}

TEST(Worker, NobodyIsToldOfACancelledJob) {
  Worker worker;
  worker.request([](const Progress&) { throw Cancelled(); });
  EXPECT_TRUE(worker.waitForEnd(5));
  EXPECT_EQ(worker.takeFailure(), std::nullopt);
}

TEST(Worker, LatestRequestWins) {
  std::atomic<bool> release{false};
  std::atomic<int> started{0}, last{0};
  Worker worker;
  worker.request([&](const Progress&) {
    ++started;
    while (!release) std::this_thread::sleep_for(100us);  // busy until everything is asked for
  });
  ASSERT_TRUE(waitUntil([&] { return started == 1; }));
  for (int i = 1; i <= 100; ++i) {
    worker.request([&, i](const Progress&) {
      ++started;
      last = i;
    });
  }
  release = true;
  ASSERT_TRUE(waitUntil([&] { return last == 100; }));
  EXPECT_TRUE(waitUntil([&] { return !worker.busy(); }));
  EXPECT_EQ(started, 2) << "all between the first and the last were replaced before they began";
}

TEST(Worker, NewRequestCancelsTheRunningOne) {
  std::atomic<bool> running{false}, cancelled{false}, second{false};
  Worker worker;
  worker.request([&](const Progress& progress) {
    running = true;
    runForever(progress);
    cancelled = true;
  });
  ASSERT_TRUE(waitUntil([&] { return running.load(); }));
  worker.request([&](const Progress&) { second = true; });
  EXPECT_TRUE(waitUntil([&] { return second.load(); }));
  EXPECT_TRUE(cancelled);
}

TEST(Worker, RequestNeverWaitsForTheRunningJob) {
  std::atomic<bool> release{false};
  Worker worker;
  worker.request([&](const Progress&) {
    while (!release) std::this_thread::sleep_for(100us);  // a job that does not look at its token
  });
  ASSERT_TRUE(waitUntil([&] { return worker.busy(); }));
  std::atomic<bool> second{false};
  worker.request([&](const Progress&) { second = true; });
  worker.cancel();
  worker.request([&](const Progress&) { second = true; });
  EXPECT_FALSE(second);
  release = true;
  EXPECT_TRUE(waitUntil([&] { return second.load(); }));
}

TEST(Worker, FailureIsAValue) {
  std::atomic<int> wakes{0};
  Worker worker([&] { ++wakes; });
  worker.request([](const Progress&) { throw std::runtime_error("no such mesh"); });
  ASSERT_TRUE(waitUntil([&] { return wakes > 0; }));
  EXPECT_EQ(worker.takeFailure(), "no such mesh");
  EXPECT_EQ(worker.takeFailure(), std::nullopt);
  worker.request([](const Progress&) {});
  EXPECT_TRUE(waitUntil([&] { return wakes > 1; })) << "and it goes on working";
}

TEST(Worker, FailureThatWasNotTakenGoesWithTheNextRequest) {
  std::atomic<int> wakes{0};
  Worker worker([&] { ++wakes; });
  const auto fail = [](const Progress&) { throw std::runtime_error("no such mesh"); };
  worker.request(fail);
  ASSERT_TRUE(waitUntil([&] { return wakes > 0; }));
  worker.request([](const Progress&) {});
  EXPECT_EQ(worker.takeFailure(), std::nullopt) << "nobody waits for that job any more";
  ASSERT_TRUE(waitUntil([&] { return wakes > 1; }));
  worker.request(fail);
  ASSERT_TRUE(waitUntil([&] { return wakes > 2; }));
  worker.cancel();
  EXPECT_EQ(worker.takeFailure(), std::nullopt);
}

TEST(Worker, ReportsItsShare) {
  std::atomic<bool> release{false};
  Worker worker;
  worker.request([&](const Progress& progress) {
    progress.update(0.5);
    while (!release) std::this_thread::sleep_for(100us);
  });
  EXPECT_TRUE(waitUntil([&] { return worker.fraction() == 0.5; }));
  release = true;
}

TEST(Worker, ManyThreadsMayAsk) {
  std::atomic<int> done{0};
  {
    Worker worker;
    std::vector<std::thread> askers;
    for (int t = 0; t < 4; ++t) {
      askers.emplace_back([&] {
        for (int i = 0; i < 200; ++i) {
          worker.request([&](const Progress& progress) { done += progress.update(1); });
          if (i % 3 == 0) worker.cancel();
          worker.busy();
          worker.fraction();
          worker.takeFailure();
        }
      });
    }
    for (std::thread& asker : askers) asker.join();
  }  // the destructor cancels what is left
  EXPECT_LE(done, 800);
}

TEST(Worker, DestructorDoesNotHang) {
  Worker worker;
  worker.request(runForever);
}

}  // namespace
}  // namespace anamorph
