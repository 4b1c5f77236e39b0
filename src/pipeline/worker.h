// One background thread for what is too long for a frame: refining, matching, tracing pictures. The latest
// request wins: a new one cancels the one that runs and replaces the one that waits, because what the user
// dragged a moment ago nobody wants to see any more. No call but waitForEnd() waits for a job.
//
//   frame:   request(A) ... request(B) ......... takeFailure(), Mailbox::take()
//   worker:  [A runs, is cancelled][B runs, puts results into mailboxes, wakes the window]
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "base/progress.h"

namespace anamorph {

/// A place for the newest value, put by one thread and taken by another.
template <typename Value>
class Mailbox {
 public:
  void put(Value value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    value_ = std::move(value);
  }
  /// The value put last, once; nothing when it was taken already.
  std::optional<Value> take() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(value_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<Value> value_;
};

class Worker {
 public:
  /// A job looks at progress.cancelled() often and returns soon after; it delivers through mailboxes of its
  /// own. What it reports is what fraction() returns.
  using Job = std::function<void(const Progress& progress)>;

  /// `wake` is called from the worker's thread after every finished job (a window posts itself an event in
  /// it).
  explicit Worker(std::function<void()> wake = {});
  /// Cancels and waits for the running job.
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  void request(Job job);
  /// Drops the waiting job and cancels the running one.
  void cancel();

  bool busy() const;
  /// Waits until nothing runs or waits any more, at most so long; returns whether that is so.
  bool waitForEnd(double seconds);
  /// How far the running job is, 0..1.
  double fraction() const;
  /// The message of the last job when it threw, once. Forgotten with the next request() or cancel().
  std::optional<std::string> takeFailure();

 private:
  void loop();

  const std::function<void()> wake_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Job waiting_;
  std::optional<CancelToken> running_;
  double fraction_ = 0;
  std::optional<std::string> failure_;
  bool stopping_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace anamorph
