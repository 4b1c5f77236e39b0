#include "base/parallel_for.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <limits>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#include "base/check.h"

namespace anamorph {
namespace {

TEST(ParallelFor, CoversEveryIndexOnceInChunksOfAtMostTheGrain) {
  for (const int threads : {1, 2, 3, 16, 0, -1}) {
    for (const std::size_t count : {0, 1, 2, 7, 64, 1000}) {
      for (const std::size_t grain : {1, 2, 7, 64, 5000}) {
        std::vector<std::atomic<int>> visits(count);
        parallelFor(count, grain, threads, [&](std::size_t begin, std::size_t end) {
          CHECK(begin < end && end <= count && end - begin <= grain);
          for (std::size_t i = begin; i < end; ++i) ++visits[i];
        });
        const bool once = std::all_of(visits.begin(), visits.end(), [](const auto& n) { return n == 1; });
        ASSERT_TRUE(once) << count << " indices, grain " << grain << ", " << threads << " threads";
      }
    }
  }
}

TEST(ParallelFor, TheLargestGrainIsOneChunk) {
  for (const std::size_t grain :
       {std::numeric_limits<std::size_t>::max(), std::numeric_limits<std::size_t>::max() / 2}) {
    std::size_t first = 99, last = 0;
    parallelFor(10, grain, 2, [&](std::size_t begin, std::size_t end) {
      first = begin;
      last = end;
    });
    EXPECT_EQ(first, 0u);
    EXPECT_EQ(last, 10u);
  }
}

TEST(ParallelFor, OneThreadIsTheCallerInAscendingOrder) {
  const std::thread::id caller = std::this_thread::get_id();
  std::vector<std::size_t> begins;
  parallelFor(100, 7, 1, [&](std::size_t begin, std::size_t) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    begins.push_back(begin);
  });
  EXPECT_EQ(begins.size(), 15u);
  EXPECT_TRUE(std::is_sorted(begins.begin(), begins.end()));
}

TEST(ParallelFor, SeveralThreadsWorkAtOnce) {
  // Each of the two chunks waits for the other: one thread alone would never come to an end.
  std::atomic<int> arrived{0};
  std::mutex mutex;
  std::set<std::thread::id> workers;
  parallelFor(2, 1, 2, [&](std::size_t, std::size_t) {
    ++arrived;
    while (arrived < 2) std::this_thread::yield();
    const std::lock_guard<std::mutex> lock(mutex);
    workers.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(workers.size(), 2u);
  EXPECT_EQ(workers.count(std::this_thread::get_id()), 1u);
}

TEST(ParallelFor, RethrowsWhatABodyThrowsAndStops) {
  for (const int threads : {1, 2, 4}) {
    std::atomic<std::size_t> chunks{0};
    const auto run = [&] {
      parallelFor(1000000, 1, threads, [&](std::size_t begin, std::size_t) {
        ++chunks;
        if (begin == 10) throw std::runtime_error("chunk 10");
      });
    };
    EXPECT_THROW(run(), std::runtime_error) << threads;
    EXPECT_LT(chunks, 1000000u) << threads;
  }
}

TEST(ParallelFor, AThrowOnEveryThreadIsOneException) {
  const auto run = [] {
    parallelFor(64, 1, 8, [](std::size_t, std::size_t) { throw std::runtime_error("all"); });
  };
  for (int i = 0; i < 50; ++i) EXPECT_THROW(run(), std::runtime_error);
}

TEST(ParallelFor, AGrainOfZeroIsAProgrammingError) {
  EXPECT_THROW(parallelFor(1, 0, 1, [](std::size_t, std::size_t) {}), ProgrammingError);
}

TEST(HardwareThreads, IsAtLeastOne) {
  EXPECT_GE(hardwareThreads(), 1);
}

}  // namespace
}  // namespace anamorph
