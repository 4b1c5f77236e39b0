// Jobs of the disk: in order, none lost, nobody waits.

#include "app/write_queue.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"

namespace anamorph {
namespace {

using Seconds = std::chrono::duration<double>;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return Seconds(std::chrono::steady_clock::now() - start).count();
}

TEST(WriteQueue, DoesJobsInOrderAndSaysHowTheyWent) {
  std::vector<int> done;
  WriteQueue queue;
  for (int i = 0; i < 5; ++i) {
    queue.add("job " + std::to_string(i), [&done, i] {
      if (i == 3) throw Error("no", "disk");
      done.push_back(i);
    });
  }
  ASSERT_TRUE(queue.finish(20));
  EXPECT_TRUE(queue.idle());
  EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 4}));
  const auto outcomes = queue.takeOutcomes();
  ASSERT_EQ(outcomes.size(), 5u);
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(outcomes[static_cast<std::size_t>(i)].name, "job " + std::to_string(i));
    EXPECT_EQ(outcomes[static_cast<std::size_t>(i)].failure, i == 3 ? "disk: no" : "");
  }
  EXPECT_TRUE(queue.takeOutcomes().empty());
}

TEST(WriteQueue, DoesTheNewestOfANameThatWaits) {
  std::promise<void> goOn;
  std::vector<std::string> done;
  WriteQueue queue;
  queue.add("a", [&done, wait = goOn.get_future().share()] {
    wait.get();
    done.push_back("first");
  });
  while (queue.idle()) {
  }
  for (const char* text : {"1", "2", "3"}) queue.add("b", [&done, text] { done.push_back(text); });
  queue.add("c", [&done] { done.push_back("c"); });
  goOn.set_value();
  ASSERT_TRUE(queue.finish(20));
  EXPECT_EQ(done.front(), "first");
  EXPECT_EQ(done.back(), "c");
  EXPECT_NE(std::find(done.begin(), done.end(), "3"), done.end());
}

TEST(WriteQueue, EndsWhenAllIsDone) {
  auto done = std::make_shared<int>(0);
  {
    WriteQueue queue;
    for (int i = 0; i < 3; ++i) queue.add(std::to_string(i), [done] { ++*done; });
  }
  EXPECT_EQ(*done, 3);
}

TEST(WriteQueue, LeavesADiskThatHangsToItself) {
  auto goOn = std::make_shared<std::promise<void>>();
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> finished = done->get_future();
  const auto start = std::chrono::steady_clock::now();
  {
    WriteQueue queue([] { ADD_FAILURE() << "who has ended is not woken"; });
    queue.add("hangs", [goOn, done] {
      goOn->get_future().get();
      done->set_value();
    });
    while (queue.idle()) {
    }
  }
  EXPECT_LT(secondsSince(start), 1.5);
  goOn->set_value();
  EXPECT_EQ(finished.wait_for(Seconds(20)), std::future_status::ready);
}

TEST(WriteQueue, NamesWhatIsNotDone) {
  auto goOn = std::make_shared<std::promise<void>>();
  WriteQueue queue;
  queue.add("done", [] {});
  queue.add("fails", [] { throw Error("no", "disk"); });
  EXPECT_EQ(queue.undone(20), std::vector<std::string>{"fails"});
  queue.takeOutcomes();
  EXPECT_TRUE(queue.undone(20).empty());
  queue.add("hangs", [goOn] { goOn->get_future().get(); });
  while (queue.idle()) {
  }
  queue.add("waits", [] {});
  EXPECT_EQ(queue.undone(0.05), (std::vector<std::string>{"hangs", "waits"}));
  goOn->set_value();
  EXPECT_TRUE(queue.undone(20).empty());
}

TEST(WriteQueue, WakesAfterEveryJob) {
  std::promise<void> woken;
  WriteQueue queue([&woken] { woken.set_value(); });
  queue.add("a", [] {});
  EXPECT_EQ(woken.get_future().wait_for(Seconds(20)), std::future_status::ready);
}

}  // namespace
}  // namespace anamorph
